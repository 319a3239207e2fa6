"""What these experiments can see, what they confuse, and which experiment would tell more."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import chain

from .contests import Ranked, contest, expected
from .effect_signals import Made, Planned, changes
from .fitting.fitted_model import Model, Trial
from .fitting.identifiability import blind_to, confused, visibility
from .fitting.predictor import Candidate
from .fitting.replay import Replay
from .tracing.named import balance_of, coordinate_of
from .tracing.slow_state import RUN
from .tracing.verdict import Verdict


@dataclass(frozen=True)
class Sight:
    """What the experiments see, do not see and confuse.

    Parameters
    ----------
    visible : mapping of str to float
        Relative rise of the error that each effect would cause at its typical size.
    blind, confused : tuples
        Effects that would go unseen; pairs that could not be told apart, with the part imitated.
    run_next : mapping of pair to tuple of (experiment, distance)
        For each confused or contested pair the experiments that add most to how far the runs that
        were made hold the two apart [noise deviations].
    reveals : mapping of str to tuple of (experiment, size of the signal)
        For each effect that would go unseen, where it shows most [noise deviations].
    needed : mapping of str to float
        Distance from which on the runs of an experiment settle a question: the wrong effect would
        raise their error by what counts (`VISIBLE`).
    planned : sequence of Replay
        Experiments that this rig can do, of all that is asked.
    """

    visible: Mapping[str, float]
    blind: tuple[str, ...]
    confused: tuple[tuple[str, str, float], ...]
    run_next: Mapping[tuple[str, str], Ranked]
    reveals: Mapping[str, Ranked] = field(default_factory=dict)
    needed: Mapping[str, float] = field(default_factory=dict)
    planned: Sequence[Replay] = ()


def sight(
    base: Model,
    candidates: Sequence[Candidate],
    replays: Sequence[Replay],
    planned: Sequence[Replay] = (),
    verdicts: Sequence[Verdict] = (),
    unit: float = 1.0,
    forms: Sequence[tuple[Trial, Trial]] = (),
) -> Sight:
    """Simulate every candidate at its typical size.

    Parameters
    ----------
    base : Model
    candidates : sequence of Candidate
    replays : sequence of Replay
        The runs that were made.
    planned : sequence of Replay
        Experiments that could be made; without any the runs that were made are ranked.
    verdicts : sequence of Verdict
        Of the rounds; what they leave contested is asked as well.
    unit : float
        Error of a perfect model in the deviations that residuals are measured in.
    forms : sequence of (Trial, Trial)
        What was named, and a declared value of its family that does as well.
    """
    # Forms with a size for every clutch, and further ones, show no other effect than the plain one.
    listed = [c for c in candidates if c.listed]
    models = {c.name: base.predictor.extended(c) for c in listed}
    made = Made(changes(base, listed, models, replays, unit))
    # Of a declared value a share that a refit may take is none that data should show.
    effects = {c.name: made.by_name[c.name] for c in listed if not c.declared}
    pairs, blind = confused(effects), blind_to(effects)
    doubtful = [pair for verdict in verdicts for pair in contested(verdict, listed)]
    named = {(a.candidate.name, b.candidate.name): (a, b) for a, b in forms}
    either = {pair: trials for pair, trials in named.items() if set(pair) <= models.keys()}
    doubtful += either
    asked = dict.fromkeys([(a, b) for a, b, _ in pairs] + doubtful)
    further: Made | Planned = made
    run_next = {}
    if planned:
        needed = {*blind, *chain.from_iterable(asked)}
        runs = expected(base.predictor, base.values, planned)
        tried = [c for c in listed if c.name in needed]
        further = Planned(made, changes(base, tried, models, runs, unit))
    fought = {pair: trials for v in verdicts for pair, trials in _fitted(v).items()} | either
    for a, b in asked:
        run_next[a, b] = further.apart(a, b)
        if planned and (a, b) in fought:
            pair = models[a], models[b]
            fitted, ranked = fought[a, b], run_next[a, b]
            run_next[a, b] = contest(base, pair, fitted, ranked, planned, unit, replays)
    return Sight(
        {name: visibility(change) for name, change in effects.items()},
        blind,
        pairs,
        run_next,
        {name: further.showing(name) for name in blind},
        further.needed(),
        planned,
    )


def contested(verdict: Verdict, candidates: Sequence[Candidate]) -> list[tuple[str, str]]:
    """Pairs of the best candidate and what the verdict does not exclude in its place."""
    best = verdict.accepted
    if best is None:
        return []
    found = [t.candidate.listed_as for t in verdict.rivals]
    asked = set(verdict.as_well)
    for balance in (balance_of(c) for c in verdict.as_well if coordinate_of(c) == RUN):
        asked |= {f"{balance}:{name}" for name in ("time", "heat", "distance")}
    found += [
        c.name
        for c in candidates
        if c.family != best.candidate.family and set(c.coordinates) & asked
    ]
    own = best.candidate.listed_as
    return [(own, name) for name in dict.fromkeys(found)]


def _fitted(verdict: Verdict) -> dict[tuple[str, str], tuple[Trial, Trial]]:
    """Contested pairs of which both were fitted in their plain forms."""
    best = verdict.accepted
    if best is None or best.candidate.listed_as != best.candidate.name:
        return {}
    plain = [t for t in (best, *verdict.rivals) if t.candidate.listed_as == t.candidate.name]
    return {(best.candidate.name, t.candidate.name): (best, t) for t in plain if t is not best}
