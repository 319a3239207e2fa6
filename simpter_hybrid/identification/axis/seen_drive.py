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
from ..recordings.channel_map import ChannelMap
from ..recordings.checks import Finding
from ..recordings.recording import RecordedRun, Recording
from ..recordings.row_step import row_step
from ..recordings.smoothing import rate_of_change, speed_width
from .drive_force import Motor, motors_of
from .signals import SEEN, AxisSignals

#: Rows count in which what was told is more than this part of the largest: a dead band is below.
COUNTS = 0.25
#: Numbers are told that are off by this part of what they are measured by, and by so many standard
#: errors.
OFF, ERRORS = 0.05, 4.0
#: Standard errors are those of the law with each of so many blocks of rows left out; rows of each.
BLOCKS, ROWS = 20, 10
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
    motor = next(iter(motors_of(declared)), None)
    found = []
    for name in (n for n in s.seen if n in recording.channels):
        signal, told = name.removeprefix(SEEN), s.driving(recording)
        law = _law(name, recording, motor, s)
        what = f"{signal} is not compared, since it was measured beside {told}, which drives"
        kind = "current" if signal == "current" else "force"
        right = (
            f"{signal} as the input, a {kind}-drive in the model and no {told} in the map, to "
            "leave the driver out of what is looked for"
        )
        found.append(Finding.of_all(what, law, right))
    return tuple(found)


def _law(name: str, recording: Recording, motor: Motor | None, s: AxisSignals) -> str:
    """Words on the driver by the sensor `name`."""
    rows = _rows(name, recording, s)
    if rows is None or not isinstance(motor, Motor) or getattr(motor, "coasting", 0.0) > 0.0:
        return "no law of the driver can be fitted to it"
    fitted = _numbers(rows, name, motor, recording, s)
    blocks = np.array_split(np.arange(len(rows)), BLOCKS)
    without = [_numbers(np.delete(rows, b, axis=0), name, motor, recording, s) for b in blocks]
    off = []
    for one, *others in zip(fitted, *without, strict=True):
        spread = float(np.std([o.seen for o in others])) * np.sqrt(BLOCKS - 1.0)
        apart = abs(one.seen - one.declared)
        if apart > max(OFF * one.size, ERRORS * spread):
            off.append(one.words)
    if not off:
        return "it goes with a driver and a motor as declared"
    return f"{BY_IT}{' and '.join(off)}"


def _numbers(
    rows: np.ndarray, name: str, motor: Motor, recording: Recording, s: AxisSignals
) -> list[Told]:
    """What the law says of the driver."""
    told, speed, seen = rows.T
    columns = np.column_stack([np.ones(told.size), told, speed, np.sign(told)])
    zero, gain, back, missing = np.linalg.lstsq(columns, seen, rcond=None)[0]
    current, channel = name == f"{SEEN}current", recording.channels[name]
    largest, driver = float(np.abs(told).max()), recording.channels[s.driving(recording) or ""]
    lost = -missing / gain
    unit = (lambda x: f"{x:.4g} V") if s.supplied(recording) else driver.written_size
    found = [
        Told(zero, 0.0, float(np.abs(seen).max()), f"the zero is {channel.written_size(zero)}"),
        Told(lost, 0.0, largest, f"{unit(lost)} of what is told never arrive"),
    ]
    if isinstance(motor, VoltageDrive):
        constant = -back / gain
        resistance = (1.0 if current else constant) / gain
        return [*found, *_of_motor(constant, resistance, motor)]
    fastest, most = float(np.abs(speed).max()), float(np.abs(seen).max())
    falls = f"it falls by {channel.written_size(-back * fastest)} at the largest speed"
    found.append(Told(back * fastest, 0.0, most, f"{falls}, as of a motor that voltage drives"))
    return [*found, *_of_gain(gain, current, motor, channel)]


def _of_motor(constant: float, resistance: float, motor: VoltageDrive) -> Iterator[Told]:
    for what, value, declared in (
        ("resistance", resistance, motor.resistance),
        ("constant", constant, motor.constant),
    ):
        says = f"the motor's {what} is {value:.4g} (declared {declared:.4g}; SI units)"
        yield Told(value, declared, declared, says)


def _of_gain(gain: float, current: bool, motor: Motor, channel: ChannelMap) -> Iterator[Told]:
    if current and not isinstance(motor, CurrentDrive):
        return  # how many amperes a unit of the drive makes nobody declared
    declared = 1.0 if current else motor.constant
    size = abs(declared)
    yield Told(gain, declared, size, f"it is {gain / declared:.4g} times what is declared")


def _rows(name: str, recording: Recording, s: AxisSignals) -> np.ndarray | None:
    """Told, speed and seen (rows, 3) where much is told; None if they tell no law."""
    runs = [_of_run(r, name, recording, s) for r in recording.runs if name in r.channels]
    rows = np.vstack(runs)
    rows = rows[np.isfinite(rows).all(axis=1)]
    told, speed = np.abs(rows[:, 0]), np.abs(rows[:, 1])
    rows = rows[told > COUNTS * told.max(initial=0.0)]
    if len(rows) < BLOCKS * ROWS or not speed.max() > 0.0:
        return None
    a, b = rows[:, 0] / told.max(), rows[:, 1] / speed.max()
    apart = np.linalg.cond(np.column_stack([np.ones(a.size), a, b, np.sign(a)]))
    return rows if apart < TOGETHER else None


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
