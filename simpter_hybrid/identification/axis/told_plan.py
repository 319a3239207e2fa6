"""Planned experiments of an axis that no logged drive moves: set points, a motion, a release.

What is asked for is laid down; what the sensors would then see the model itself tells, and their
noise is added.  From there on a planned run is treated like a recorded one.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from ..fitting.replay import Replay
from ..recordings.recording import Recording
from ..recordings.row_step import row_step
from ..recordings.smoothing import lagged
from ..rigs.scenario_predictor import ScenarioPredictor
from .experiments import AxisReach, axis_experiments, ends_of, most_of, strokes
from .plan import (
    FASTEST,
    FOLLOWS,
    LONGEST,
    Planned,
    lasts,
    planned_recording,
    sensed,
    shaken,
    usual,
)
from .signals import AxisSignals

#: Speeds at which an axis is let go, as parts of the largest.
LET_GO = {"the largest speed": 1.0, "half the largest": 0.5, "a fifth of the largest": 0.2}
#: Quantiles of what presses at which slow strokes are made; part by which the first has to be less.
PRESSED, APART = (0.05, 0.5, 0.95), 0.9
#: Part of the largest speed of these strokes.
SLOW = 0.3


def motion_reach(
    replays: Sequence[Replay], inertia: float, every: Sequence[Replay] = (), alone: bool = False
) -> AxisReach:
    """How far recorded runs went, by their motion alone; `every`: as of `axis_reach`.

    An axis let `alone` is planned to go on as long as in any recorded run: a car coasts for
    minutes, of which the first seconds show nothing.
    """
    x = np.concatenate([r.notes["position"] for r in replays])
    v = np.concatenate([r.notes["speed"] for r in replays])
    fastest = max(most_of(r.notes["speed"], 0.95) for r in replays)
    longest = math.inf if alone else LONGEST
    step, long = row_step(replays[0].time), lasts(every or replays, longest)
    return AxisReach(*ends_of(x, v), fastest, inertia * shaken(replays), inertia, long, step)


def set_points(recording: Recording, reach: AxisReach) -> Planned:
    """Courses that the model's own servo is to follow, from rest at their beginning."""
    s = AxisSignals()
    return {
        name: _known(recording, {s.position: np.full(x.size, x[0]), s.reference: x}, reach)
        for name, x in axis_experiments(reach).items()
    }


def motions(recording: Recording, reach: AxisReach) -> Planned:
    """Courses that a tester is to follow, as fast as recorded rows can tell them.

    Where what presses was changed, also slow strokes under little, usual and much of it.
    """
    s, rate = AxisSignals(), min(FOLLOWS / reach.step, FASTEST)
    samples = 1.0 / (rate * reach.step)

    def followed(course: np.ndarray) -> np.ndarray:
        away = course - course[0]
        return course[0] + lagged(lagged(away, samples), samples)

    courses = {name: followed(x) for name, x in axis_experiments(reach).items()}
    found = {name: _known(recording, {s.position: x}, reach) for name, x in courses.items()}
    seen = [r.channels[s.press] for r in recording.runs if s.press in r.channels]
    levels = np.quantile(np.concatenate(seen), PRESSED) if seen else np.zeros(3)
    if levels[0] < APART * levels[-1]:
        half, middle = 0.5 * (reach.high - reach.low), 0.5 * (reach.high + reach.low)
        slow = followed(middle + strokes(reach.time, SLOW * reach.speed, half))
        turn = (np.arange(slow.size) * levels.size) // slow.size
        name = "slow strokes under little, usual and much pressure"
        found[name] = {**_known(recording, {s.position: slow}, reach), s.press: levels[turn]}
    return found


def releases(recording: Recording, reach: AxisReach) -> Planned:
    """The axis let go: at several speeds from the middle, and at rest from both ends.

    Where only a speed was logged nobody knows its ends, and nothing pulls it away from them.
    """
    s, middle = AxisSignals(), 0.5 * (reach.high + reach.low)
    starts = {
        f"let go at {told}{way}": (middle, sign * part * reach.speed)
        for told, part in LET_GO.items()
        for sign, way in ((1.0, ""), (-1.0, ", backwards"))
    }
    if not recording.channels[s.position].summed:
        starts |= {"let go at rest at the lower end": (reach.low, 0.0)}
        starts |= {"let go at rest at the upper end": (reach.high, 0.0)}
    return {
        name: _known(recording, {s.position: q + v * reach.time}, reach)
        for name, (q, v) in starts.items()
    }


def _known(
    recording: Recording, laid_down: Mapping[str, np.ndarray], reach: AxisReach
) -> dict[str, np.ndarray]:
    """Channels of a planned run: what is laid down, and all others as they usually are."""
    s = AxisSignals()
    found = {
        n: np.full(reach.time.size, v) for n in recording.channels for v in usual(recording, n)
    }
    if s.speed in found:
        found[s.speed] = np.gradient(laid_down[s.position], reach.time)
    return found | dict(laid_down)


def told_by_model(
    recording: Recording,
    predictor: ScenarioPredictor,
    values: Mapping[str, float],
    planned: Planned,
    time: np.ndarray,
    made: Callable[[Recording], Sequence[Replay]],
    free: bool = False,
) -> Recording:
    """What a recording of the planned runs would hold, by this model.

    Parameters
    ----------
    recording : Recording
        Its map and the noise of its channels are taken over.
    predictor : ScenarioPredictor
    values : mapping of str to float
    planned : mapping
        Channels by the name of a run; measured ones are replaced by what the model predicts.
    time : ndarray (samples,)
        Of every run [s].
    made : callable (recording) -> sequence of Replay
    free : bool
        Whether each run goes on from its start, whatever its placeholder did.
    """
    replays = made(planned_recording(recording, planned, time))
    replays = [replace(r, restarts=()) if free else r for r in replays]
    told = predictor.simulated(values, replays)  # a placeholder tells no start
    seen = {n for n, c in recording.channels.items() if c.role == "measured" and n in told}
    found = {
        replay.name: {
            n: np.interp(time, replay.time, told[n][i]) if n in seen else x
            for n, x in planned[replay.name].items()
        }
        for i, replay in enumerate(replays)
    }
    return planned_recording(recording, sensed(recording, found, time), time)
