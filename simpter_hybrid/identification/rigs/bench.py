"""What a diagnosis needs of a rig: replays, the model that predicts them, traces, candidates."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from ..fitting.replay import Replay
from ..recordings.checks import Finding
from ..recordings.recording import Recording
from ..tracing.limits import SINGLE, Limits
from ..tracing.traced import Tracer
from .effect_candidate import EffectCandidate
from .input_noise import InputNoise
from .scenario_predictor import ScenarioPredictor

#: Planned runs, without measured values, by the refitted model's values and the runs it was judged
#: by (which tell in what deviations residuals are measured).
Plan = Callable[[Mapping[str, float], Sequence[Replay]], Sequence[Replay]]


@dataclass(frozen=True)
class Bench:
    """One rig with its recording.

    Parameters
    ----------
    parts : mapping of str to list of Replay
        ``fit``, ``select``, ``report``.
    predictor : ScenarioPredictor
        The declared model.
    tracer : callable (replays) -> Tracer
    candidates : tuple of EffectCandidate
    made : callable (recording, part) -> list of Replay
        Makes the replays of one part of a recording, also of a changed one.
    jumps : str
        Channel around whose jumps samples say nothing; "" where none is looked at.
    limits : Limits
        What is noise where runs are not repeated.
    noise : InputNoise, optional
        Where inputs or starts are noisy: what that does to predictions, and so to the weights that
        residuals deserve and to the floor.
    plain_first : bool
        Whether to search once without that, for a model to weigh by.
    experiments : callable (values, replays) -> sequence of Replay, optional
        What this rig could do, without measured values: from these the next run is recommended.
    remarks : tuple of Finding
        What of the recording was left out.
    by_run : bool
        Whether to ask, of what no effect explains, if a declared parameter differs between runs;
        two halves of one run are none.
    runs_alone : bool
        Whether that is asked only of what no effect explains, without a search beside it.
    common : tuple of str
        Declared parameters of which that is not asked.
    zero : EffectCandidate, optional
        A number of no tolerance of which it is asked as well.
    """

    parts: Mapping[str, list[Replay]]
    predictor: ScenarioPredictor
    tracer: Callable[[Sequence[Replay]], Tracer]
    candidates: tuple[EffectCandidate, ...]
    made: Callable[[Recording, str], list[Replay]]
    jumps: str = ""
    limits: Limits = SINGLE
    noise: InputNoise | None = None
    plain_first: bool = False
    experiments: Plan | None = None
    remarks: tuple[Finding, ...] = ()
    by_run: bool = False
    runs_alone: bool = False
    common: tuple[str, ...] = ()
    zero: EffectCandidate | None = None
