"""What the sensor of an axis's speed may do wrong: a gyroscope's zero, a late tachometer.

Windows begin at speeds of the record, and so with its error: they are put right with it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from ...device import Device
from ...problems import InvalidInput, Problem
from ..fitting.predictor import Parameter
from ..fitting.replay import Replay, Restart
from ..recordings.agreement import lateness
from ..recordings.recording import Recording
from ..recordings.row_step import row_step
from ..rigs.effect_candidate import EffectCandidate
from ..rigs.sensor_errors import Key
from .force_sensor import LONGEST, TIMED, TYPICAL
from .late_course import Course
from .signals import AxisSignals
from .starts import MORE, PARABOLA
from .windows import BENT_ROWS, CUBIC, half_width, span_of

#: The fit's parameters [rad/s or m/s; s], and their fields in readings.
OFFSET, LAG, DELAY = "speed-offset.offset", "speed-lag.lag", "speed-delay.delay"
AVERAGE = "speed-average.time"
SENSOR = {"offset": OFFSET, "filter": LAG, "delay": DELAY, "average": AVERAGE}
#: Family of the forms in which a speed comes late.
FAMILY = "late speed sensor"
#: Channel of a prediction: rate of change of a speed that is shown late.
SHOWN = "rate of the shown speed"
#: Largest offset that is looked for and a typical one, over the largest speed.
MOST, OFF = 0.5, 0.01
#: A rate of change, whose noise a late speed's start has times how late it is, is that of a cubic
#: over so many times the rows on either side that a start itself is fitted to.
REACH = 3
#: Part of the error that this may add: where the speed of own motors was filtered its lag left 0.8
#: to 2.3 % more than one of the drive, where the drive lagged 6 to 15 % more.
BLURRED = 0.03
#: What tells a late speed from what else is late, without a position and beside one.
BESIDE_NONE = "The position logged beside the speed: the two at the same instants."
BESIDE = "The same recording without its speed: by the position the drive alone may be late."
#: Where it shows: friction and springs act on another speed than the one shown.
WHERE = ("time", "speed", "slip_velocity", "position")


def speed_keys(device: Device) -> dict[Key, str]:
    """Signal and field of the speed sensor's errors in readings -> its name in a fit."""
    signal = f"speed of {device.coordinates[0]}"
    return {(signal, field): name for field, name in SENSOR.items()}


def refuse_early(declared: Mapping[str, float], name: str) -> None:
    """What a speed will be is not known where a window ends.

    Raises
    ------
    InvalidInput
        If a declared sensor of the speed is ahead of time.
    """
    if (delay := declared.get(DELAY, 0.0)) < 0.0:
        what, right = "a speed that is ahead cannot be taken into account", "a delay above zero"
        raise InvalidInput([Problem(name, "readings", what, f"{-delay:g} s", right)])


def speed_candidates(
    recording: Recording, replays: Sequence[Replay], s: AxisSignals, turning: bool, alone: bool
) -> tuple[EffectCandidate, ...]:
    """A zero of the speed that is off, and a speed that comes late; none where none was measured.

    Late to nothing is a speed of an axis that is let `alone`, and not late one that goes with the
    position logged beside it.
    """
    seen = [r.observed[s.speed].values for r in replays if s.speed in r.observed]
    if not seen:
        return ()
    most = max(float(np.quantile(np.abs(values), 0.99)) for values in seen)
    offset = speed_offset(most, turning)
    summed = recording.channels[s.position].summed
    if alone or not (summed or behind_position(recording) > 0.0):
        return (offset,)
    return (offset, *late_speed(BESIDE_NONE if summed else BESIDE))


def behind_position(recording: Recording) -> float:
    """How late a speed is by the position beside it [s]; 0 where the two do not tell that it is."""
    known = [(run.time, run.channels) for run in recording.runs]
    told = lateness(known, recording.channels).get(AxisSignals.speed)
    return 0.0 if told is None else max(told[1], 0.0)


def speed_offset(most: float, turning: bool) -> EffectCandidate:
    """The candidate, on an axis whose speed reaches `most` [rad/s, or m/s of one that is straight].

    A motion in windows shows it by friction and springs, which act on another speed.
    """
    unit = "rad/s" if turning else "m/s"
    offset = Parameter(OFFSET, 0.0, -MOST * most, MOST * most, OFF * most, unit=unit)
    again = "The sensor read while the axis rests, before and after."
    return _candidate(offset, 0.0, "speed sensor", WHERE, again)


def late_speed(again: str) -> tuple[EffectCandidate, ...]:
    """Candidates: a speed that is filtered, one that is late, one averaged over so long.

    And a mean that is filtered, as a controller makes of counts, where one of these leaves more.
    `again`: what tells them.
    """
    lag = Parameter(LAG, 0.0, 0.0, LONGEST, TYPICAL, unit="s")
    delay = Parameter(DELAY, 0.0, 0.0, LONGEST, TYPICAL, unit="s")
    time = Parameter(AVERAGE, 0.0, 0.0, 2.0 * LONGEST, TYPICAL, unit="s")
    forms = (lag, TYPICAL), (delay, TYPICAL), (time, 2.0 * TYPICAL)
    made = [_candidate(one, start, FAMILY, TIMED, again) for one, start in forms]
    filtered = replace(
        made[2], name="speed-average-lag", parameters=(time, lag), sizes=(AVERAGE, LAG),
        starts=((2.0 * TYPICAL, TYPICAL), (10.0 * TYPICAL, 5.0 * TYPICAL)), further=True,
        contains=tuple(one.name for one in made), simpler=made[2].name,
    )  # fmt: skip
    return tuple(replace(one, blurred=BLURRED) for one in (*made, filtered))


def _candidate(
    parameter: Parameter, start: float, family: str, where: Sequence[str], again: str
) -> EffectCandidate:
    places = tuple(f"force:{coordinate}" for coordinate in where)
    name = parameter.name.partition(".")[0]
    return EffectCandidate(
        name, (parameter,), ((start,),), family, "sensor", places, again, sizes=(parameter.name,)
    )


def begun_right(replay: Replay, values: Mapping[str, float]) -> Replay:
    """The run with the motion that a sensor with such errors must have seen where it begins."""
    offset, late = values.get(OFFSET, 0.0), is_late(values)
    if not (offset or late) or AxisSignals.speed not in replay.observed:
        return replay  # its speeds are the positions' rates
    rows = [0, *(r.index for r in (*replay.restarts, *replay.followed))]
    behind = _behind_by(replay, values, rows) if late else dict.fromkeys(rows, 0.0)

    def anew(of: Sequence[Restart]) -> tuple[Restart, ...]:
        return tuple(replace(r, speed=r.speed + behind[r.index] - offset) for r in of)

    told = replay.start_told[1]  # of the axis itself, whatever its sensor shows
    start = replay.notes["start"] + np.array([0.0, 0.0 if told else behind[0] - offset])
    return replace(
        replay, restarts=anew(replay.restarts), followed=anew(replay.followed),
        notes={**replay.notes, "start": start},
    )  # fmt: skip


def shown_speed(
    replay: Replay, speed: np.ndarray, acceleration: np.ndarray, values: Mapping[str, float]
) -> np.ndarray:
    """What such a sensor shows of a model's speed (samples,), in each window from its start.

    Before that the speed has gone straight, and so that the record shows what it does there.
    Between rows it is a parabola with the acceleration at its end: at its beginning a drive may
    have jumped.
    """
    if is_late(values) and AxisSignals.speed in replay.observed:
        begins = [0, *(r.index for r in replay.restarts)]
        behind, time = _behind_by(replay, values, begins), replay.time
        parts = []
        for a, b in pairwise([*begins, speed.size]):
            course = Course(time[a:b] - time[a], speed[a:b], acceleration[a:b],
                             behind[a] / late_by(values))  # fmt: skip
            parts.append(_shown(course, values) if b > a else speed[a:b])
        speed = np.concatenate(parts)
    return speed + values.get(OFFSET, 0.0)


def shown_rate(replay: Replay, shown: np.ndarray) -> np.ndarray:
    """Rate of change of a shown speed (samples,), in each window by itself."""
    ends = [0, *(r.index for r in replay.restarts), shown.size]
    apart = ((shown[a:b], replay.time[a:b]) for a, b in pairwise(ends))
    return np.concatenate([np.gradient(v, t) if v.size > 1 else 0.0 * v for v, t in apart])


def _shown(course: Course, values: Mapping[str, float]) -> np.ndarray:
    """What a late sensor shows of it; declared may be several errors, of which others act on it."""
    lag, delay, average = (values.get(name, 0.0) for name in (LAG, DELAY, AVERAGE))
    if average:
        time = course.time - delay
        v = (course.way(time) - course.way(time - average)) / average
    else:
        v = course.at(course.time - delay) if delay else course.speed
    if not lag:
        return v
    if average or delay:  # straight between its rows, on which it is known
        slope = np.append(0.0, np.diff(v) / np.diff(course.time))
        return Course(course.time, v, slope, course.rate).lagged(lag)
    return course.lagged(lag)


def is_late(values: Mapping[str, float]) -> bool:
    """Whether such a sensor shows the speed late."""
    return any(values.get(name, 0.0) != 0.0 for name in (LAG, DELAY, AVERAGE))


def late_by(values: Mapping[str, float]) -> float:
    """How late it shows what goes straight [s]."""
    return values.get(LAG, 0.0) + values.get(DELAY, 0.0) + 0.5 * values.get(AVERAGE, 0.0)


def _behind_by(
    replay: Replay, values: Mapping[str, float], rows: Sequence[int]
) -> dict[int, float]:
    """How much faster the axis was at some rows than its late sensor showed [rad/s or m/s].

    What is delayed, or the mean of a while, is shown later; behind a lag a speed is off by its rate
    of change times the lag.
    """
    time, lag = replay.time, values.get(LAG, 0.0)
    speed = replay.notes[AxisSignals.speed]
    half = half_width(row_step(time))
    bent, found = np.flatnonzero(replay.notes[BENT_ROWS]), {}
    for k in rows:
        first, last = span_of(k, REACH * half, speed.size, bent, PARABOLA + MORE)
        # At the end of its rows a cubic's slope is mostly noise.
        degree = CUBIC if min(k - first, last - 1 - k) >= half else PARABOLA
        near = time[first:last] - time[k], speed[first:last]
        fit = np.polynomial.Polynomial.fit(*near, degree)
        found[k] = float(lag * fit.deriv()(0.0) + fit(late_by(values) - lag) - fit(0.0))
    return found
