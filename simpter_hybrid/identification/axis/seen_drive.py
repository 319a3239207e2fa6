"""What a sensor saw of a drive that another channel tells: a current beside the voltage.

What is told drives the model, so an error of the driver is in all that is left.  The sensor tells
of the driver with no friction in it: ``seen = zero + gain told + back speed + missing sign(told)``,
the law of a motor, less the part of what was told that never arrives.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from ...loads.drive import CurrentDrive, VoltageDrive
from ...scenario import Scenario
from ..recordings.checks import Finding
from ..recordings.noise import noise_estimate
from ..recordings.recording import RecordedRun, Recording
from ..recordings.row_step import row_step
from ..recordings.smoothing import rate_of_change, speed_width
from .drive_force import Motor, motors_of
from .signals import SEEN, AxisSignals

#: Rows count in which what was told is more than this part of the largest: a dead band is below.
#: Beside a jump of more than the second part none does: a sensor may be read before or behind it.
COUNTS, JUMP = 0.25, 0.05
#: Numbers are told that are off by this part of what they are measured by, and by so many standard
#: errors.
OFF, ERRORS = 0.05, 4.0
#: Standard errors are those of the law with each of so many blocks of rows left out; rows of each.
BLOCKS, ROWS = 20, 10
#: A law that leaves this part of what is seen, and so many deviations of its noise, is none.
LEFT, NOISY = 0.1, 2.0
NO_LAW = "no law of the driver can be fitted to it"
#: A sensor whose readings go the other way by no more than this part has one sign.
ONE_SIGN = 0.05
#: Beginning of what is remarked of a driver that is not as declared.
BY_IT = "by it "
#: Told and speed that go together so nearly (condition number) tell no two numbers.
TOGETHER = 50.0


class Told(NamedTuple):
    """A number of the driver: as it is by the sensor, and as declared [SI]; in words."""

    seen: float
    declared: float
    size: float
    words: str


def seen_drive(recording: Recording, declared: Scenario, s: AxisSignals) -> tuple[Finding, ...]:
    """Remarks on the driver, by what a sensor saw of what drives beside what was told."""
    found = []
    for name in (n for n in s.seen if n in recording.channels):
        signal, told = name.removeprefix(SEEN), s.driving(recording)
        law = _law(name, recording, declared, s)
        what = f"{signal} is not compared, since it was measured beside {told}, which drives"
        kind = "current" if signal == "current" else "force"
        right = (
            f"{signal} as the input, a {kind}-drive in the model and no {told} in the map, to "
            "leave the driver out of what is looked for"
        )
        found.append(Finding.of_all(what, law, right))
    return tuple(found)


def _law(name: str, recording: Recording, declared: Scenario, s: AxisSignals) -> str:
    """Words on the driver by the sensor `name`."""
    rows, motors = _rows(name, recording, s), motors_of(declared)
    if rows is None or len(motors) != 1 or getattr(motors[0], "coasting", 0.0) > 0.0:
        return NO_LAW
    told, seen = rows[:, 0], rows[:, 2]
    if np.ptp(np.sign(told)) > 0.0 and _of_one_sign(seen):
        return f"{BY_IT}there is no sign: is it the size of it, or the supply's?"
    line = _line(rows)
    spread, left = float(np.std(seen)), float(np.std(seen - _columns(rows) @ line))
    # A current goes with what is told; a force as its declared constant has it.
    way = 1.0 if name == f"{SEEN}current" else float(np.sign(motors[0].constant))
    if line[1] * way <= 0.0 or left**2 > (1.0 - OFF) * spread**2:
        return f"{BY_IT}nothing of what is told arrives, or its sign in the map is wrong"
    if left > max(LEFT * spread, NOISY * noise_estimate(seen)):
        part = 100.0 * left / spread
        return f"{NO_LAW}: one of what is told and the speed leaves {part:.0f} %"
    fitted = _numbers(rows, name, motors[0], recording, s)
    blocks = np.array_split(np.arange(len(rows)), BLOCKS)
    without = [_numbers(np.delete(rows, b, axis=0), name, motors[0], recording, s) for b in blocks]
    off = []
    for one, *others in zip(fitted, *without, strict=True):
        spread = float(np.std([o.seen for o in others])) * np.sqrt(BLOCKS - 1.0)
        apart = abs(one.seen - one.declared)
        if apart > max(OFF * one.size, ERRORS * spread):
            off.append(one.words)
    if not off:
        return "it goes with a driver and a motor as declared"
    return f"{BY_IT}{' and '.join(off)}"


def _of_one_sign(seen: np.ndarray) -> bool:
    """Whether readings hardly go the other way."""
    low, high = float(seen.min()), float(seen.max())
    return min(-low, high) < ONE_SIGN * max(-low, high)


def _line(rows: np.ndarray) -> np.ndarray:
    """Zero, gain, back and missing of the law; nothing is missing of a drive of one sign."""
    columns = _columns(rows)
    both = 4 if np.ptp(columns[:, 3]) > 0.0 else 3  # else the last is the first again
    return np.append(np.linalg.lstsq(columns[:, :both], rows[:, 2], rcond=None)[0], 0.0)[:4]


def _columns(rows: np.ndarray) -> np.ndarray:
    """What the numbers of `_line` stand before (rows, 4)."""
    told, speed = rows[:, 0], rows[:, 1]
    return np.column_stack([np.ones(told.size), told, speed, np.sign(told)])


def _numbers(
    rows: np.ndarray, name: str, motor: Motor, recording: Recording, s: AxisSignals
) -> list[Told]:
    """What the law says of the driver."""
    told, speed, seen = rows.T
    zero, gain, back, missing = _line(rows)
    current, channel = name == f"{SEEN}current", recording.channels[name]
    driver = recording.channels[s.driving(recording) or ""]
    largest, most = float(np.abs(told).max()), float(np.abs(seen).max())
    lost = -missing / gain
    unit = (lambda x: f"{x:.4g} V") if s.supplied(recording) else driver.written_size
    one_way = " (or what is told and never arrives)" if np.ptp(np.sign(told)) == 0.0 else ""
    found = [
        Told(zero, 0.0, most, f"the zero{one_way} is {channel.written_change(zero)}"),
        Told(lost, 0.0, largest, f"{unit(lost)} of what is told never arrive"),
    ]
    if isinstance(motor, VoltageDrive):
        constant = -back / gain
        resistance = (1.0 if current else constant) / gain
        return [*found, *_of_motor(constant, resistance, motor)]
    at_most = back * float(np.abs(speed).max())
    way = "falls" if at_most < 0.0 else "rises"
    goes = f"what it shows {way} by {channel.written_size(abs(at_most))} at the largest speed"
    as_of = ", as of a motor that voltage drives" if at_most < 0.0 else ""
    found.append(Told(at_most, 0.0, most, f"{goes}{as_of}"))
    return [*found, *_of_gain(gain, current, motor)]


def _of_motor(constant: float, resistance: float, motor: VoltageDrive) -> Iterator[Told]:
    for what, value, declared in (
        ("resistance", resistance, motor.resistance),
        ("constant", constant, motor.constant),
    ):
        says = f"the motor's {what} is {value:.4g} (declared {declared:.4g}; SI units)"
        yield Told(value, declared, declared, says)


def _of_gain(gain: float, current: bool, motor: Motor) -> Iterator[Told]:
    if current and not isinstance(motor, CurrentDrive):
        return  # how many amperes a unit of the drive makes nobody declared
    declared = 1.0 if current else motor.constant
    size = abs(declared)
    yield Told(gain, declared, size, f"the gain is {gain / declared:.4g} times the declared one")


def _rows(name: str, recording: Recording, s: AxisSignals) -> np.ndarray | None:
    """Told, speed and seen (rows, 3) where much is told; None if they tell no law."""
    runs = [_of_run(r, name, recording, s) for r in recording.runs if name in r.channels]
    rows = np.vstack([np.zeros((0, 3)), *runs])
    most = float(np.abs(rows[:, 0][np.isfinite(rows[:, 0])]).max(initial=0.0))
    jumps = [np.abs(np.diff(run[:, 0], prepend=run[:1, 0])) > JUMP * most for run in runs]
    steady = [~(jump | np.append(jump[1:], False)) for jump in jumps]
    rows = rows[np.concatenate([np.zeros(0, bool), *steady]) & np.isfinite(rows).all(axis=1)]
    rows = rows[np.abs(rows[:, 0]) > COUNTS * most]
    if len(rows) < BLOCKS * ROWS or not np.abs(rows[:, 1]).max() > 0.0:
        return None
    columns = _columns(rows / np.abs(rows).max(axis=0))
    both = 4 if np.ptp(columns[:, 3]) > 0.0 else 3
    return rows if np.linalg.cond(columns[:, :both]) < TOGETHER else None


def _of_run(run: RecordedRun, name: str, recording: Recording, s: AxisSignals) -> np.ndarray:
    """The same three (samples, 3) of one run; nothing is told where the motor's ends are open."""
    told = run.channels[s.driving(recording) or ""]
    told = told * run.channels[s.supply] if s.supplied(recording) else told
    ones = np.ones(run.time.size)
    told = np.where(run.channels.get(s.engaged, ones) > 0.5, told, np.nan)
    if s.speed in run.channels:
        speed = run.channels[s.speed]
    else:
        width = speed_width(row_step(run.time))
        speed = rate_of_change(run.time, run.channels[s.position], width)
    return np.column_stack([told, speed, run.channels[name]])
