"""What these experiments can see, what they confuse, and which experiment would tell more."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import chain

import numpy as np

from .contests import Ranked, contest, expected
from .fitting.fit import Fitter
from .fitting.fitted_model import Model, Trial
from .fitting.identifiability import VISIBLE, blind_to, confused, separation, visibility
from .fitting.predictor import Candidate, Parameter, Predictor
from .fitting.replay import Replay
from .fitting.residual import residual_parts
from .recordings.projection import beyond
from .tracing.named import balance_of, coordinate_of
from .tracing.slow_state import RUN
from .tracing.verdict import Verdict

#: A candidate is tried at so many typical changes of each of its parameters from no effect.
SIZE = 3.0
#: Experiments named for each question.
NAMED = 3
#: Where a linear step of the declared parameters leaves no more than this part of an effect's
#: power, so many of their steps are simulated to see how well they imitate it.
STEPS, MUCH = 3, 0.3


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
        For each confused or contested pair the experiments that hold the two farthest apart [noise
        deviations].
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


@dataclass(frozen=True)
class Signals:
    """What every candidate does at its typical size beyond what declared parameters imitate.

    `owner` (N,) is the index of each residual's experiment in `names`.
    """

    by_name: Mapping[str, np.ndarray]
    owner: np.ndarray
    names: Sequence[str]

    def apart(self, a: str, b: str) -> Ranked:
        """Experiments that hold two effects apart, farthest first."""
        found = separation(self.by_name[a], self.by_name[b], self.owner, self.names)
        return tuple(found.items())[:NAMED]

    def needed(self) -> dict[str, float]:
        """Size of a signal that raises the error of an experiment's runs by what counts."""
        count = np.bincount(self.owner, minlength=len(self.names))
        least = np.sqrt(((1.0 + VISIBLE) ** 2 - 1.0) * count)
        return dict(zip(self.names, least.tolist(), strict=True))

    def showing(self, name: str) -> Ranked:
        """Experiments in which one effect shows, most first."""
        power = np.bincount(self.owner, self.by_name[name] ** 2, len(self.names))
        order = np.argsort(-power, kind="stable")[:NAMED]
        return tuple((self.names[k], float(np.sqrt(power[k]))) for k in order)


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
    made = _signals(base, listed, models, replays, [r.name for r in replays], unit)
    # Of a declared value a share that a refit may take is none that data should show.
    effects = {c.name: made.by_name[c.name] for c in listed if not c.declared}
    pairs, blind = confused(effects), blind_to(effects)
    doubtful = [pair for verdict in verdicts for pair in contested(verdict, listed)]
    named = {(a.candidate.name, b.candidate.name): (a, b) for a, b in forms}
    either = {pair: trials for pair, trials in named.items() if set(pair) <= models.keys()}
    doubtful += either
    asked = dict.fromkeys([(a, b) for a, b, _ in pairs] + doubtful)
    further, run_next = made, {}
    if planned:
        needed = {*blind, *chain.from_iterable(asked)}
        runs, few = expected(base.predictor, base.values, planned), [r.experiment for r in planned]
        tried = [c for c in listed if c.name in needed]
        further = _signals(base, tried, models, runs, few, unit)
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


def _signals(
    base: Model, candidates: Sequence[Candidate], models: Mapping[str, Predictor],
    replays: Sequence[Replay], experiments: Sequence[str], unit: float,
) -> Signals:  # fmt: skip
    """What each candidate does to the residuals beyond what declared parameters could imitate.

    Declared parameters imitate an effect only as far as their steps go.  Runs of the same
    experiment, by `experiments`, count together.
    """
    predictor, values = base.predictor, base.values
    fitter = Fitter(predictor, replays)
    at = fitter.residuals(values)
    columns = fitter.jacobian(values, at)
    parts = residual_parts(predictor.predict(values, replays), replays)
    names = list(dict.fromkeys(experiments))
    owner = np.repeat(
        [names.index(experiments[i]) for _, i, _ in parts], [p.size for _, _, p in parts]
    )
    without = np.concatenate([p for _, _, p in parts])
    columns = columns[: without.size]
    signals = {}
    for candidate in candidates:
        own = {
            p.name: p.value if np.isfinite(p.tolerance) else typical_value(p, s)
            for p, s in zip(candidate.parameters, candidate.starts[0], strict=True)
        }
        changed = residual_parts(
            models[candidate.name].predict({**values, **own}, replays), replays
        )
        change = np.concatenate([p for _, _, p in changed]) - without
        imitated = Imitation(predictor, values, replays, without, columns, unit)
        signals[candidate.name] = imitated.left_of(change) / unit
    return Signals(signals, owner, names)


@dataclass(frozen=True)
class Imitation:
    """How far declared parameters could do to the residuals what an effect does.

    `at` (N,) are the residuals at `values`, `columns` (N, declared) their Jacobian, `unit` the
    deviation in which what is visible counts.  Residuals are clipped, so a large change points
    elsewhere than the columns: what a linear step leaves of an effect may be gone once that step is
    simulated.
    """

    predictor: Predictor
    values: Mapping[str, float]
    replays: Sequence[Replay]
    at: np.ndarray
    columns: np.ndarray
    unit: float

    @property
    def declared(self) -> Sequence[Parameter]:
        """Parameters that may imitate an effect."""
        return self.predictor.parameters

    def left_of(self, change: np.ndarray) -> np.ndarray:
        """Part of a change (N,) that declared parameters cannot make; simulated where small."""
        size, low, high, reached = np.array(
            [(p.typical, p.lower, p.upper, self.values[p.name]) for p in self.declared]
        ).T
        best, current = beyond(change, self.columns), change
        for _ in range(STEPS):
            if best @ best > MUCH * (change @ change) or visibility(best / self.unit) < VISIBLE:
                break
            step = np.linalg.lstsq(self.columns, current, rcond=None)[0]
            reached = np.clip(reached + size * step, low, high)
            current = change - (self._residuals(reached) - self.at)
            rest = beyond(current, self.columns)
            best = min(best, rest, key=lambda r: float(r @ r))
        return best

    def _residuals(self, values: np.ndarray) -> np.ndarray:
        given = {p.name: float(x) for p, x in zip(self.declared, values, strict=True)}
        parts = residual_parts(self.predictor.predict(given, self.replays), self.replays)
        return np.concatenate([p for _, _, p in parts])


def typical_value(parameter, start: float) -> float:
    """A value at which the effect is as large as is typical."""
    if abs(start) > 1e-12:
        return start
    value = parameter.value + SIZE * parameter.typical
    return min(max(value, parameter.lower), parameter.upper)
