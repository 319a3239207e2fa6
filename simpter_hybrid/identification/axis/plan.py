"""Planned experiments of a driven axis as the recordings that they would give.

A servo that has a little less drive than was recorded is simulated along a course, with the model
and with the rate of the recorded rows.  What is asked for is the motion that comes out, and the
drive that makes it: corners of the course are gone from it, it begins at rest, and this drive can
do it.  Both are then logged in the noise of the sensors.  From there on a planned run is treated
like a recorded one.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
from scipy.integrate import cumulative_trapezoid

from ...compiled import simulate
from ...controllers.axis_servo import HOLDS, PositionServo
from ...measuring.sampling import sample
from ...scenario import Scenario
from ..fitting.replay import Replay
from ..recordings.noise import channel_noise
from ..recordings.recording import RecordedRun, Recording
from ..recordings.row_step import row_step
from ..rigs.rig import SOLVER
from .experiments import AxisReach, axis_experiments, ends_of, most_of, no_faster
from .motor import motor_of
from .pieces import since_its_beginning
from .signals import AxisSignals

#: Channels by the name of a planned run.
Planned = Mapping[str, Mapping[str, np.ndarray]]
#: The servo follows with this part of the rate of rows, as an angular frequency times the step ...
FOLLOWS = 0.1
#: ... and no faster than this [rad/s]; a run that is planned is no longer than this [s].
FASTEST, LONGEST = 60.0, 12.0
#: A planned motion takes this part of the recorded drive: the rest is there for a servo to put
#: right what the model does not tell.  With none left one fell behind by half of a course.
USED = 0.9
#: Of a drive too weak to turn in time all is tried again at this part of the speed, so often.
SLOWER, TRIES = 0.7, 7
#: By this part of the way that was used a planned motion may go beyond its ends.
BEYOND = 0.05


def axis_reach(
    replays: Sequence[Replay], inertia: float, constant: float, every: Sequence[Replay] = ()
) -> AxisReach:
    """How far recorded runs went.

    Parameters
    ----------
    replays : sequence of Replay
        Those whose motion counts.
    inertia : float
        [kg or kg m^2]
    constant : float
        Force for each unit of the recorded drive.
    every : sequence of Replay
        All that were made, for how long they last; without any `replays`.
    """
    x = np.concatenate([r.notes["position"] for r in replays])
    v = np.concatenate([r.notes["speed"] for r in replays])
    drive = abs(constant) * most_of(np.concatenate([r.inputs["drive"] for r in replays]), 0.99)
    return AxisReach(
        *ends_of(x, v), most_of(v, 0.95), drive or inertia * shaken(replays), inertia,
        lasts(every or replays), row_step(replays[0].time),
    )  # fmt: skip


def lasts(replays: Sequence[Replay], most: float = LONGEST) -> float:
    """How long a planned run is [s]: as the longest that was made, whole, or `most`."""
    return min(most, max(map(since_its_beginning, replays)))


def shaken(replays: Sequence[Replay]) -> float:
    """Acceleration that the liveliest recorded run kept within for most of its time."""
    return max(most_of(np.gradient(r.notes["speed"], r.time), 0.95) for r in replays)


def planned_axis(
    recording: Recording, model: Scenario, reach: AxisReach, signals: AxisSignals
) -> tuple[Recording, Planned]:
    """What a recording of all planned experiments would hold, by this model; what is laid down.

    Of an experiment that leaves the way (`BEYOND`) even when it is slow neither has a run.

    Parameters
    ----------
    recording : Recording
        Its map and the noise of its channels are taken over.
    model : Scenario
    reach : AxisReach
    signals : AxisSignals
    """
    names = list(axis_experiments(reach))
    made: dict[str, dict[str, np.ndarray]] = {}
    before: dict[str, np.ndarray] = {}
    for speed in (reach.speed * SLOWER ** np.arange(TRIES)).tolist():
        if left := [n for n in names if n not in made]:
            courses = _courses(recording, replace(reach, speed=speed))
            # A course of steps is the same at any speed, and so is what becomes of it.
            other = [n for n in left if n not in before or (courses[n] != before[n]).any()]
            tried = {n: _simulated(model, reach, courses[n], signals, recording) for n in other}
            before = courses
            made |= {n: x for n, x in tried.items() if _keeps_to(reach, x[signals.position])}
    made = {n: made[n] for n in names if n in made}
    asked = {n: _driven_so(recording, channels, signals) for n, channels in made.items()}
    return planned_recording(recording, sensed(recording, made, reach.time), reach.time), asked


def _courses(recording: Recording, reach: AxisReach) -> dict[str, np.ndarray]:
    """Courses (samples,) that the servo is told; of a summed speed as fast as can be asked for."""
    courses, most = axis_experiments(reach), reach.speed * reach.step
    if not recording.channels[AxisSignals().position].summed:
        return courses
    return {name: no_faster(course, most) for name, course in courses.items()}


def _keeps_to(reach: AxisReach, position: np.ndarray) -> bool:
    """Whether a motion (samples,) keeps to the way that was used; none does that failed."""
    more = BEYOND * (reach.high - reach.low)
    return bool(np.all((position >= reach.low - more) & (position <= reach.high + more)))


def _driven_so(
    recording: Recording, made: Mapping[str, np.ndarray], signals: AxisSignals
) -> dict[str, np.ndarray]:
    """What is laid down of a simulated run: its motion, and what drives it without set points.

    Where set points were logged a servo is there to follow the motion.  Elsewhere nobody knows
    whether there is one: the drive is told as well, and that is what is replayed.
    """
    summed = recording.channels[signals.position].summed
    moves = signals.speed if summed else signals.position
    servo = signals.reference in recording.channels
    drives = [] if servo else [n for n in signals.drive if n in made]
    return {n: made[n] for n in (moves, *drives)} | laid_down(made)


def laid_down(channels: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
    """Those of a planned run's channels that its experimenter sets, beside a course."""
    s = AxisSignals()
    return {n: channels[n] for n in (s.reference, s.press, s.supply) if n in channels}


def followed(recording: Recording, course: np.ndarray, step: float) -> dict[str, np.ndarray]:
    """A course (samples,) as a servo is told it: its speed, where no position was logged."""
    s = AxisSignals()
    if recording.channels[s.position].summed:
        return {s.speed: np.gradient(course, step)}
    return {s.position: course}


def sensed(recording: Recording, planned: Planned, time: np.ndarray) -> Planned:
    """Channels with the noise of their sensors; runs of which the model failed are left out."""
    s, generator = AxisSignals(), np.random.default_rng(1)
    found = {}
    for name, channels in planned.items():
        if not all(np.isfinite(x).all() for x in channels.values()):
            continue
        noisy = {
            c: x + generator.normal(0.0, _noise(recording, c, s), time.size)
            for c, x in channels.items()
        }
        if recording.channels[s.position].summed:
            noisy[s.position] = cumulative_trapezoid(noisy[s.speed], time, initial=0.0)
        found[name] = noisy
    return found


def planned_recording(recording: Recording, planned: Planned, time: np.ndarray) -> Recording:
    """The planned runs, with the map of a recording; `time` (samples,) is that of every run [s]."""
    runs = tuple(
        # Windows are found by rows: no two runs may have the same.
        RecordedRun(name, name, name, (k, k + time.size), time, dict(channels))
        for k, (name, channels) in enumerate(planned.items())
    )
    return replace(recording, source="planned", runs=runs, findings=())


def _simulated(
    model: Scenario, reach: AxisReach, course: np.ndarray, signals: AxisSignals,
    recording: Recording,
) -> dict[str, np.ndarray]:  # fmt: skip
    """Every channel of one run without noise; NaN where the model failed."""
    _, constant = motor_of(model)
    rate = min(FOLLOWS / reach.step, FASTEST)
    stiffness = reach.inertia * rate**2 / constant
    pressed = usual(recording, signals.press) or model.command
    points = tuple(zip(reach.time.tolist(), course.tolist(), strict=True))
    limit = USED * reach.force / abs(constant)
    servo = PositionServo(points, stiffness, 2.0 * stiffness / rate, limit)
    scenario = replace(
        model, controllers=((servo, 1),), period=reach.step, t_end=float(reach.time[-1]),
        q=(float(course[0]),), qd=(0.0,), command=pressed, excitation=pressed, **SOLVER,
    )  # fmt: skip
    run = simulate(scenario)
    if run.status != "finished":
        return {signals.position: np.full(reach.time.size, np.nan)}
    made = sample(run, reach.time)
    supply = usual(recording, signals.supply)
    drive = made.held[HOLDS[0]] / (supply[0] if signals.supplied(recording) else 1.0)
    name = next(d for d in signals.drive if d in recording.channels)
    found = {signals.position: made.q[:, 0], signals.speed: made.qd[:, 0], name: drive}
    constants = {signals.supply: supply, signals.press: usual(recording, signals.press)}
    found |= {c: np.full(drive.size, level[0]) for c, level in constants.items() if level}
    return {c: x for c, x in found.items() if c in recording.channels}


def usual(recording: Recording, name: str) -> tuple[float, ...]:
    """Median of a channel over all runs, as a tuple of one [SI]; () if it was not recorded."""
    seen = [run.channels[name] for run in recording.runs if name in run.channels]
    return (float(np.median(np.concatenate(seen))),) if seen else ()


def _noise(recording: Recording, name: str, signals: AxisSignals) -> float:
    """Standard deviation of a channel's noise [SI]; what a driver is told has none, unless said."""
    told = name in signals.told and recording.channels[name].noise is None
    return 0.0 if told else channel_noise(recording, name)
