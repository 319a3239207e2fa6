"""What the noise of inputs and starts does to a prediction, and how residuals allow for it.

A noisy force or start moves a prediction along a few smooth curves, far where a clutch was about
to stick or to let go.  Such a curve is no evidence against a model however many samples it spans.
So each window's residual is weighed by the covariance ``1 + sum of those curves' squares``: parts
along the curves are scaled down, the rest keeps the full weight of the sensor's noise.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import islice

import numpy as np

from ..fitting.repeats import OUTLYING
from ..fitting.replay import Observation, Replay
from ..fitting.residual import deviation, without_line
from ..recordings.noise import driven_step, run_noise
from ..recordings.noise_left import shaped
from ..recordings.recording import RecordedRun, Recording
from ..recordings.row_step import row_step
from .free_start import sensitivities
from .scenario_predictor import ScenarioPredictor

#: How often noise is added anew to learn the curves, and how often more to estimate the floor.
DRAWS, FURTHER = 6, 3
#: A window that noise moves by more than this many standard deviations, and by more than `OUTLYING`
#: times as far as half of all windows, has another event in it.
EVENT = 1.0
#: Second differences beyond so many deviations are the signal's: those of noise have 2.4 of them.
BENT = 6.0
#: A curve so many deviations large says nothing at all, and takes its part of a floor away.
NO_EVIDENCE = 1e6
#: Rows of which so many follow one another at the usual step come regularly.
REGULAR = 0.8


@dataclass(frozen=True)
class InputNoise:
    """What noise does to the predictions of one rig.

    Parameters
    ----------
    predictor : ScenarioPredictor
    recording : Recording
    made : callable (recording) -> sequence of Replay
        How the rig makes replays of a recording.
    exact : frozenset of str
        Inputs that were told to a driver: known as they are, unless the map states their noise.
    sensed : frozenset of str
        Inputs that a sensor saw: noisy even where a row holds until the next.  Of these, and of
        what is exact among them, it is not known where between two rows they jumped.
    draws : int
        Times that the noise is added once more to learn the curves.
    """

    predictor: ScenarioPredictor
    recording: Recording
    made: Callable[[Recording], Sequence[Replay]]
    exact: frozenset[str] = frozenset()
    sensed: frozenset[str] = frozenset()
    draws: int = DRAWS

    def disturbed(self, seed: int) -> Recording:
        """The recording with the noise of every noisy channel added once more."""
        # Each channel's own: one that nothing uses changes no other's.
        drawn = {c: np.random.default_rng([seed, *c.encode()]) for c in self.recording.channels}
        runs = []
        for run in self.recording.runs:
            changed = {c: self._disturbed(run, c, v, drawn[c]) for c, v in run.channels.items()}
            runs.append(replace(run, channels=changed))
        return replace(self.recording, runs=tuple(runs))

    def _disturbed(
        self, run: RecordedRun, name: str, values: np.ndarray, generator: np.random.Generator
    ) -> np.ndarray:
        channel = self.recording.channels[name]
        exact = channel.noise is None and name in self.exact
        held = channel.noise is None and channel.held != "sampled"
        if (exact or held) and name not in self.sensed:
            lost = in_lost_rows(values, run.time, channel.held, generator) if held else 0.0
            return values + lost
        sd = np.full(values.size, 0.0 if exact else run_noise(values, channel, run.time))
        if name in self.sensed and channel.held == "sampled":
            sd = np.hypot(sd, between_rows(values, sd[0]))
        white = generator.standard_normal(values.size)
        noisy = values + sd * shaped(channel, run.time, white)
        if name in self.sensed and channel.noise is None:
            noisy += left_out(values, generator)
        return noisy

    def again(self, seed: int) -> Sequence[Replay]:
        """The replays of all runs with that noise."""
        return self.made(self.disturbed(seed))

    def moved(
        self, values: Mapping[str, float], replays: Sequence[Replay], seeds: Iterable[int]
    ) -> Iterator[list[dict[str, np.ndarray]]]:
        """For each seed, how far noise moves each run's predicted channels [SI]."""
        first = self.predictor.simulated(values, replays)
        for seed in seeds:
            others: dict[str, list[Replay]] = {}  # a name may be that of several runs, in order
            for run in self.again(seed):
                others.setdefault(run.name, []).append(run)
            again = [_begun_as(r, others[r.name].pop(0)) for r in replays]
            second = self.predictor.simulated(values, again)
            yield [
                {name: np.nan_to_num(second[name][i] - first[name][i]) for name in replay.observed}
                for i, replay in enumerate(replays)
            ]

    def weighed(self, values: Mapping[str, float], replays: Sequence[Replay]) -> list[Replay]:
        """Replays whose residuals allow for what noise does to a prediction by this model.

        Those that are not cut into windows stay as they are: over a whole run noise has more
        shapes than draws, and its size is in the floor.
        """
        if not any(seen.windows for r in replays for seen in r.observed.values()):
            return list(replays)
        draws = list(_while_moving(self.moved(values, replays, range(1, self.draws + 1))))
        free = [r for r in replays if r.start_free]
        begins = iter(sensitivities(self.predictor.simulated, values, free) if free else ())
        found = []
        for i, replay in enumerate(replays):
            observed, start = {}, next(begins) if replay.start_free else {}
            for name, seen in replay.observed.items():
                moves = np.column_stack([d[i][name] for d in draws]) / (seen.sd * seen.own)
                curves = moves / np.sqrt(len(draws))
                if name in start:  # any other start would do: along these nothing counts
                    curves = np.column_stack([curves, NO_EVIDENCE * start[name] / seen.sd])
                observed[name] = replace(seen, curves=_shapes(seen, curves))
            found.append(replace(replay, observed=observed))
        return found

    def floors(
        self, values: Mapping[str, float], parts: Mapping[str, Sequence[Replay]]
    ) -> dict[str, float]:
        """What a perfect model would score: the sensors' noise and what noisy inputs add to it.

        The latter is how far the prediction moves when inputs and starts carry their noise once
        more; windows in which it moves far (a start that now sticks or does not) are left out.
        """
        seeds = range(self.draws + 1, self.draws + FURTHER + 1)
        every = [run for runs in parts.values() for run in runs]
        draws = [iter(draw) for draw in _while_moving(self.moved(values, every, seeds))]
        return {
            part: self._floor(runs, [list(islice(draw, len(runs))) for draw in draws])
            for part, runs in parts.items()
        }

    @staticmethod
    def _floor(
        replays: Sequence[Replay], draws: Sequence[Sequence[Mapping[str, np.ndarray]]]
    ) -> float:
        """Floor of some runs, by how far each draw of noise moves each of them."""
        further = [moves for draw in draws for moves in draw]
        squares, own, scale, rows, compared = [], [], [], [], []
        for replay, moves in zip(list(replays) * len(draws), further, strict=True):
            for name, seen in replay.observed.items():
                # Windows are those of all rows; what has none is one.
                every = np.ones(moves[name].size, bool) if seen.windows else seen.keep
                noisy = replace(seen, values=moves[name], keep=every, slopes=())
                error = deviation(noisy, 0.0 * moves[name])
                error /= seen.sd * seen.own
                begins = seen.windows or (0,)
                ends = (*begins[1:], error.size)
                for k, (a, b) in enumerate(zip(begins, ends, strict=True)):
                    if a == b:  # of this run nothing is compared
                        continue
                    whole = bool(seen.keep[a:b].any()) if seen.windows else b - a
                    rows.append(float(whole))  # of a window that is not compared: none
                    compared.append(float(seen.keep[a:b].sum()) if seen.windows else rows[-1])
                    squares.append(float(np.mean(error[a:b] ** 2)))
                    lost = 1.0 - (1.0 - seen.curves[k][1]) ** 2 if seen.curves else np.zeros(1)
                    line = 2.0 if seen.windows and seen.lines else 0.0
                    own.append(max(0.0, 1.0 - (float(lost.sum()) + line) / (b - a)))
                    scale.append((seen.weight * seen.own) ** 2)
        most = max(EVENT**2, OUTLYING**2 * float(np.median(squares)))
        typical = np.array(squares) < most
        weight, scaled = np.array(rows if any(rows) else np.ones(len(rows))), np.array(scale)
        moved = np.average((scaled * squares)[typical], weights=weight[typical])
        rows_told = compared if any(compared) else rows
        return float(np.sqrt(np.average(scaled * own, weights=rows_told) + moved))


def _while_moving(
    draws: Iterable[list[dict[str, np.ndarray]]],
) -> Iterator[list[dict[str, np.ndarray]]]:
    """Draws up to the first that moves nothing: no input is noisy then, and no other draw moves."""
    for draw in draws:
        yield draw
        if not any(np.any(course) for moves in draw for course in moves.values()):
            return


def _begun_as(replay: Replay, noisy: Replay) -> Replay:
    """A run with noise added; where its start is free, that of the run without."""
    again = replace(noisy, own=replay.own)
    if not replay.start_free:
        return again
    return replace(again, notes={**again.notes, "start": replay.notes["start"]})


def left_out(values: np.ndarray, generator: np.random.Generator) -> np.ndarray:
    """Random part (samples,) that a coarse sensor may round off, the same while its value stays."""
    step = driven_step(values)
    if step is None:
        return np.zeros(values.size)
    stays = np.cumsum(np.abs(np.diff(values, prepend=values[0])) > step / 2.0)
    return step * generator.uniform(-0.5, 0.5, stays[-1] + 1)[stays]


def in_lost_rows(
    values: np.ndarray, time: np.ndarray, held: str, generator: np.random.Generator
) -> np.ndarray:
    """Random change (samples,) of a held input's mean where rows are lost.

    The input goes on as it was before the lost rows, but may have become that of the next row at
    any instant among them.  Where rows come irregularly none is known to be lost.
    """
    if values.size < 2:
        return np.zeros(values.size)
    steps = np.diff(time) / row_step(time)
    lost = np.rint(steps) - 1.0
    at = np.flatnonzero(lost > 0.0)
    if np.mean(lost == 0.0) < REGULAR:
        return np.zeros(values.size)
    part = lost[at] / (lost[at] + 1.0) * generator.uniform(0.0, 1.0, at.size)
    change = part * np.diff(values)[at]
    moved = np.zeros(values.size)
    if held == "after":
        moved[at] = change
    else:
        moved[at + 1] = -change
    return moved


def between_rows(values: np.ndarray, sd: float) -> np.ndarray:
    """Standard deviation (samples,) of a sampled input about the straight lines between its rows.

    A jump at an unknown (uniform) instant between two rows moves the mean there by 0.29 of the
    jump; two rows that are off by a quarter of the bend do as much.  Bends that noise makes do not
    count.  Those that a cubic follows do: without them a null of 50 rows a second, whose force
    turns sharply, was at 1.57 times its floor, with them at 1.00.
    """
    bend = np.abs(np.diff(values, 2))
    return np.pad(np.where(bend > BENT * sd, bend / 4.0, 0.0), 1)


def _shapes(seen: Observation, curves: np.ndarray) -> tuple[tuple[np.ndarray, np.ndarray], ...]:
    """Orthonormal curves per window, and the part of a residual along them that is taken away."""
    found = []
    for a, b in zip(seen.windows, (*seen.windows[1:], len(curves)), strict=True):
        apart = curves[a:b].T
        block = np.column_stack([without_line(c) if seen.lines else c for c in apart])
        shape, size, _ = np.linalg.svd(block, full_matrices=False)
        found.append((shape, 1.0 - 1.0 / np.sqrt(1.0 + size**2)))
    return tuple(found)
