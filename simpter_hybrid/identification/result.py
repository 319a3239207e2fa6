"""A diagnosis with what a report needs of it, and the models that come of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from ..scenario import Scenario
from .carried_over import Harmful, TakenBack
from .doubted_channels import Doubt
from .empirical import Empirical
from .far_off import FarOff
from .fitting.fitted_model import Split, Trial
from .fitting.floor import Floors
from .fitting.replay import Replay
from .held_out_gains import HeldOutGain
from .recordings.checks import Finding
from .recordings.recording import Recording
from .rigs.bench import Plan
from .rigs.corrected import with_tolerances
from .rigs.effect_candidate import EffectCandidate
from .ruling_run import RulingRun
from .run_levels import RunLevels
from .tracing.limits import REPEATED, Limits
from .tracing.rounds import SearchResult
from .tracing.traced import Tracer


@dataclass(frozen=True)
class Diagnosis:
    """A diagnosis with what a report needs of it.

    Parameters
    ----------
    search : SearchResult
    split : Split
    groups : mapping of str to tuple of str
        What was fitted, what selected, what is reported on, for a reader.
    errors : mapping of str to mapping of str to float
        ``declared``, ``refitted``, ``after``, ``empirical`` (if there is one), ``floor`` -> channel
        -> error on reported runs [SI].
    error_by_stage : mapping of str to float
        The same over all channels, in standard deviations.
    error_by_experiment : mapping of str to mapping of str to float
        The same, stage -> experiment -> error, but for the floor.
    candidates : tuple of EffectCandidate
        What was tried.
    experiments : callable (values, replays) -> sequence of Replay, optional
        What the rig could do next.
    empirical : Empirical or None
        A curve over the variable on which what is left depends, where no effect explains it.
    tracer, limits
        As the search used them.
    doubts : tuple of Doubt
        Channels of which the map may have the sign or the unit wrong.
    far_off : FarOff or None
        Declared numbers that may be farther off than their tolerances say.
    ruling_run : RulingRun or None
        A fitted run that may be unlike the others.
    remarks : tuple of Finding
        What of the recording was left out.
    levels : tuple of RunLevels
        The declared parameters that explain most by differing from run to run, if that was asked;
        reported runs have the common values.
    fitted : sequence of Replay
        The fitted runs, repeated ones apart.
    floors : Floors
        Errors of a perfect model.
    repeated : tuple of tuple of str
        Names of runs that count as one driven again, where what they differ by is the floor.
    over_noise : float
        The floor of the selecting runs, in times the noise known otherwise.
    cut_short : float
        Steps after which the search was cut short; 0 if it came to its end.
    interrupted : bool
        Whether somebody ended it.
    unfinished : bool
        Whether its last pass was ended so, and is not used.
    taken_back : TakenBack or None
        What the runs held out contradict.
    harmful : tuple of Harmful
        Further effects that they contradict beside what is named.
    forms : mapping of str to tuple of Trial
        Effect -> its other forms that do as well.
    only_held_out : bool
        Whether these alone show more than noise.
    recording : Recording or None
        The recording as its rig took it: channels have the names by which they are compared.
    gains : sequence of sequence of HeldOutGain
        What the best candidates of each round do to the runs held out, if that was asked.
    off_pace : bool
        Whether the model goes another way than the record where its error does not tell that.
    """

    search: SearchResult
    split: Split
    groups: Mapping[str, tuple[str, ...]]
    errors: Mapping[str, Mapping[str, float]]
    error_by_stage: Mapping[str, float]
    error_by_experiment: Mapping[str, Mapping[str, float]]
    candidates: tuple[EffectCandidate, ...] = ()
    experiments: Plan | None = None
    empirical: Empirical | None = None
    tracer: Tracer | None = None
    limits: Limits = REPEATED
    doubts: tuple[Doubt, ...] = ()
    far_off: FarOff | None = None
    ruling_run: RulingRun | None = None
    remarks: tuple[Finding, ...] = ()
    levels: tuple[RunLevels, ...] = ()
    fitted: Sequence[Replay] = ()
    floors: Floors = Floors(1.0, 1.0, 1.0)
    repeated: tuple[tuple[str, ...], ...] = ()
    over_noise: float = 1.0
    cut_short: float = 0.0
    interrupted: bool = False
    unfinished: bool = False
    taken_back: TakenBack | None = None
    harmful: tuple[Harmful, ...] = ()
    forms: Mapping[str, tuple[Trial, ...]] = field(default_factory=dict)
    only_held_out: bool = False
    recording: Recording | None = None
    gains: Sequence[Sequence[HeldOutGain]] = ()
    off_pace: bool = False


def corrected(found: Diagnosis, name: str) -> Scenario:
    """The scenario of the corrected model, which other commands run."""
    model: Any = found.search.corrected
    return with_tolerances(_scenario(model, name), model.predictor.effects)


def with_curve(found: Diagnosis, name: str) -> Scenario | None:
    """The corrected scenario with the empirical curve; None if there is no curve."""
    return _scenario(found.empirical.model, name) if found.empirical is not None else None


def _scenario(model: Any, name: str) -> Scenario:
    return replace(model.predictor.scenario(model.values), name=name)
