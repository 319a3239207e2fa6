"""What effects do to the residuals of runs beyond what declared parameters could do there.

A run that could be made is judged together with the runs that were made: these hold fast what it
leaves open alone, and what several planned runs show only together none of them shows.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from .contests import Ranked
from .fitting.fit import Fitter
from .fitting.fitted_model import Model
from .fitting.identifiability import least_visible, separation
from .fitting.predictor import Candidate, Parameter, Predictor
from .fitting.replay import Replay
from .fitting.residual import residual_parts
from .recordings.projection import beyond

#: A candidate is tried at so many typical changes of each of its parameters from no effect.
SIZE = 3.0
#: Experiments named for each question.
NAMED = 3
#: Where a linear step of the declared parameters leaves no more than this part of an effect's
#: power, so many of their steps are simulated to see how well they imitate it.
STEPS, MUCH = 3, 0.3


@dataclass(frozen=True)
class Changes:
    """What every candidate does to the residuals of some runs at its typical size.

    Parameters
    ----------
    predictor : Predictor
    values : mapping of str to float
        Of the declared parameters.
    replays : sequence of Replay
    at : ndarray (N,)
        Residuals at these values.
    columns : ndarray (N, declared)
        Their Jacobian.
    run : ndarray of int (N,)
        Index of each residual's run.
    by_name : mapping of str to ndarray (N,)
        Candidate -> change of the residuals.
    unit : float
        Deviation in which what is visible counts.
    """

    predictor: Predictor
    values: Mapping[str, float]
    replays: Sequence[Replay]
    at: np.ndarray
    columns: np.ndarray
    run: np.ndarray
    by_name: Mapping[str, np.ndarray]
    unit: float

    def of(self, runs: Sequence[int]) -> Changes:
        """The same of some of the runs alone; `runs` rise."""
        here = np.isin(self.run, runs)
        return replace(
            self,
            replays=[self.replays[i] for i in runs],
            at=self.at[here],
            columns=self.columns[here],
            run=np.searchsorted(runs, self.run[here]),
            by_name={name: change[here] for name, change in self.by_name.items()},
        )

    def beside(self, made: Changes) -> Changes:
        """The same of these runs behind those that were made."""
        return replace(
            self,
            replays=[*made.replays, *self.replays],
            at=np.concatenate([made.at, self.at]),
            columns=np.concatenate([made.columns, self.columns]),
            run=np.concatenate([made.run, len(made.replays) + self.run]),
            by_name={n: np.concatenate([made.by_name[n], x]) for n, x in self.by_name.items()},
        )

    def left(self, name: str, least: float | None = None) -> np.ndarray:
        """What declared parameters cannot do of a candidate's change (N,), in units; simulated.

        Below `least`, by default what counts as visible in these runs, none looks closer.
        """
        imitated = Imitation(
            self.predictor, self.values, self.replays, self.at, self.columns,
            self.unit * (least_visible(self.at.size) if least is None else least),
        )  # fmt: skip
        return imitated.left_of(self.by_name[name]) / self.unit

    def condensed(self, names: Sequence[str]) -> np.ndarray:
        """As few rows as columns and changes have the same products with one another."""
        named = [self.by_name[n] for n in names]
        return np.linalg.qr(np.column_stack([self.columns, *named])).R


def changes(
    base: Model, candidates: Sequence[Candidate], models: Mapping[str, Predictor],
    replays: Sequence[Replay], unit: float,
) -> Changes:  # fmt: skip
    """Simulate every candidate at its typical size.

    Parameters
    ----------
    base : Model
    candidates : sequence of Candidate
    models : mapping of str to Predictor
        With each of them.
    replays : sequence of Replay
    unit : float
        Error of a perfect model in the deviations that residuals are measured in.
    """
    predictor, values = base.predictor, base.values
    fitter = Fitter(predictor, replays)
    at = fitter.residuals(values)
    columns = fitter.jacobian(values, at)
    parts = residual_parts(predictor.predict(values, replays), replays)
    run = np.repeat([i for _, i, _ in parts], [p.size for _, _, p in parts])
    without = np.concatenate([p for _, _, p in parts])
    found = {}
    for candidate in candidates:
        own = {
            p.name: p.value if np.isfinite(p.tolerance) else typical_value(p, s)
            for p, s in zip(candidate.parameters, candidate.starts[0], strict=True)
        }
        changed = residual_parts(
            models[candidate.name].predict({**values, **own}, replays), replays
        )
        found[candidate.name] = np.concatenate([p for _, _, p in changed]) - without
    return Changes(predictor, values, replays, without, columns[: without.size], run, found, unit)


class Made:
    """What the runs that were made show of every candidate.

    Parameters
    ----------
    seen : Changes
    """

    def __init__(self, seen: Changes) -> None:
        self.seen = seen
        self.by_name = {name: seen.left(name) for name in seen.by_name}
        names = [r.name for r in seen.replays]
        self.names = list(dict.fromkeys(names))
        self.owner = np.array([self.names.index(n) for n in names], int)[seen.run]

    def apart(self, a: str, b: str) -> Ranked:
        """Runs that hold two effects apart, farthest first."""
        found = separation(self.by_name[a], self.by_name[b], self.owner, self.names)
        return tuple(found.items())[:NAMED]

    def showing(self, name: str) -> Ranked:
        """Runs in which one effect shows, most first."""
        power = np.bincount(self.owner, self.by_name[name] ** 2, len(self.names))
        order = np.argsort(-power, kind="stable")[:NAMED]
        return tuple((self.names[k], float(np.sqrt(power[k]))) for k in order)

    def needed(self) -> dict[str, float]:
        """Size of a signal that raises the error of a run by what counts."""
        count = np.bincount(self.owner, minlength=len(self.names))
        return {name: least_visible(n) for name, n in zip(self.names, count.tolist(), strict=True)}


class Planned:
    """What the runs of each planned experiment would add to those that were made.

    Parameters
    ----------
    made : Made
    future : Changes
        Of the planned runs.
    """

    def __init__(self, made: Made, future: Changes) -> None:
        self.made, self.future = made, future
        self.runs: dict[str, list[int]] = {}
        for i, replay in enumerate(future.replays):
            self.runs.setdefault(replay.experiment, []).append(i)
        before = made.seen.condensed(list(future.by_name))
        self.by_one_step = {e: self._by_one_step(before, runs) for e, runs in self.runs.items()}

    def apart(self, a: str, b: str) -> Ranked:
        """Experiments that add most to the distance between two effects, farthest first."""
        return self._ranked(a, b)

    def showing(self, name: str) -> Ranked:
        """Experiments that add most to what shows of one effect, most first."""
        return self._ranked(name)

    def needed(self) -> dict[str, float]:
        """Size of a signal that raises the error of an experiment's runs by what counts."""
        return {
            e: least_visible(int(np.isin(self.future.run, r).sum())) for e, r in self.runs.items()
        }

    def _ranked(self, *names: str) -> Ranked:
        """Experiments by one linear step; of the first what is left by steps that are simulated."""
        before = _power(self.made.by_name, names)
        by_step = {e: _power(self.by_one_step[e], names) for e in self.runs}
        found = {}
        for experiment in sorted(by_step, key=lambda e: -by_step[e])[:NAMED]:
            own = self.future.of(self.runs[experiment])
            every = own.beside(self.made.seen)
            least = least_visible(own.at.size)
            after = _power({n: every.left(n, least) for n in names}, names)
            found[experiment] = float(np.sqrt(max(0.0, after - before)))
        return tuple(sorted(found.items(), key=lambda item: -item[1]))

    def _by_one_step(self, before: np.ndarray, runs: Sequence[int]) -> dict[str, np.ndarray]:
        """What one step of the declared parameters leaves of every change in all these runs."""
        names = list(self.future.by_name)
        rows = np.concatenate([before, self.future.of(runs).condensed(names)])
        declared = self.future.columns.shape[1]
        rest = beyond(rows[:, declared:], rows[:, :declared]) / self.future.unit
        return dict(zip(names, rest.T, strict=True))


def _power(signals: Mapping[str, np.ndarray], names: Sequence[str]) -> float:
    """Of one signal, or of what the second of two cannot do of the first."""
    first, *others = [signals[n] for n in names]
    rest = beyond(first, np.column_stack(others)) if others else first
    return float(rest @ rest)


@dataclass(frozen=True)
class Imitation:
    """How far declared parameters could do to the residuals what an effect does.

    `at` (N,) are the residuals at `values`, `columns` (N, declared) their Jacobian; what is left of
    an effect is not looked at closer below `least`, which would go unseen.  Residuals are clipped,
    so a large change points elsewhere than the columns: what a linear step leaves of an effect may
    be gone once that step is simulated.
    """

    predictor: Predictor
    values: Mapping[str, float]
    replays: Sequence[Replay]
    at: np.ndarray
    columns: np.ndarray
    least: float

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
            if best @ best > MUCH * (change @ change) or best @ best < self.least**2:
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
