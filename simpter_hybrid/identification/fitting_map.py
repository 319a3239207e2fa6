"""Whether the map of a recording of one axis and the declared model belong together."""

from __future__ import annotations

from collections.abc import Mapping
from difflib import get_close_matches

import numpy as np

from ..applied_load import Load
from ..loads.drive import CurrentDrive, ForceDrive, VoltageDrive
from ..problems import Problems, together
from ..reading.reader import one_of
from ..scenario import Scenario
from ..units import DIMENSIONS, QuantityError, is_unit, parse_quantity
from .axis.signals import SEEN, AxisSignals
from .played_rate import check_rate, usual_step
from .recordings.groups import PARTS
from .recordings.map_units import PLAIN
from .recordings.recording import Recording
from .recordings.row_step import row_step
from .recordings.shortest import lasts, longest_run, most_pieces, shortest

#: What the channels of a straight and of a turning axis are.
STRAIGHT = {"position": "length", "reference": "length", "speed": "speed", "force": "force",
            "current": "current"}  # fmt: skip
TURNING = {"position": "angle", "reference": "angle", "speed": "angular_speed", "torque": "torque",
           "current": "current"}  # fmt: skip
#: Longest interval between samples of a driven axis [s]: half a second of prediction has five.
SLOWEST = 0.1
#: Longest interval between samples of an axis let alone [s]: a second is usual, and milliseconds
#: that are called seconds are more.
SLOWEST_ALONE = 2.0
#: Part of it by which stamps of just so many seconds may be off.
ROUNDING = 1e-6
#: Most periods of the model's controller between rows of an axis that is moved from outside.
MOST_BETWEEN = 300
#: Motors by name, and the dimensions of what each is told, or a sensor of it shows.
MOTORS: Mapping[str, tuple[type[Load], tuple[str, ...]]] = {
    "voltage-drive": (VoltageDrive, ("voltage",)),
    "current-drive": (CurrentDrive, ("current",)),
    "force-drive": (ForceDrive, ("voltage", "torque", "force")),
}


def check_axis(recording: Recording, declared: Scenario) -> None:
    """Check that the map of one axis and the declared model belong together.

    Units are asked of position, speed and force or torque; a column in plain numbers is taken as
    it is. A clutch whose command never exceeds its threshold is open: nothing would rub.

    Raises
    ------
    InvalidInput
        If a unit is of another kind, if friction is off in the whole recording, if nothing moves,
        or if what drives it or its rate does not go with the model.
    """
    together(
        lambda: _check_units(recording, declared),
        lambda: _check_drive(recording),
        lambda: _check_motor(recording, declared),
        lambda: _check_every_row(recording),
        lambda: _check_moving(recording),
        lambda: _check_played(recording, declared),
        lambda: _check_closed(recording, declared),
    )


def _check_units(recording: Recording, declared: Scenario) -> None:
    """Check units: what a straight axis has in metres a turning one has in radians."""
    problems = Problems(recording.map.source)
    known = STRAIGHT if "length" in declared.device.coordinate_dimensions else TURNING
    pushes = known.get("force", known.get("torque", ""))
    seen = {f"{SEEN}force": pushes, f"{SEEN}torque": pushes, f"{SEEN}current": "current"}
    for signal, kind in {**known, **seen}.items():
        channel = recording.channels.get(signal)
        if channel is None or channel.unit in PLAIN:
            continue
        try:
            parse_quantity(f"1 {channel.unit}", kind)
        except QuantityError as error:
            what = f"{error.what}, of a device {type(declared.device).__name__}"
            right = f'a unit of {kind.replace("_", " ")}, such as "{DIMENSIONS[kind].si}"'
            problems.add(("channels", signal.removeprefix(SEEN), "unit"), what, channel.unit, right)
    problems.raise_if_any()


def _check_drive(recording: Recording) -> None:
    """An axis is driven by what was recorded, moved from outside, or said to be let alone."""
    problems = Problems(recording.map.source)
    known = (*AxisSignals().drive, AxisSignals().reference)
    drives = [d for d in known if d in recording.channels]
    moved = recording.channels["position"].role == "input"
    several = [d for d in AxisSignals().drive if d in drives]
    if recording.map.driven and not moved and len(several) > 1:
        right = (
            'role = "input" of the one that drives the model, "measured" of a current, force or '
            "torque that a sensor saw beside it"
        )
        problems.add(("channels",), "several drive the axis", ", ".join(several), right)
    if not recording.map.driven and (drives or moved):
        got = f"false, and channels.{'position' if moved else drives[0]} drives it"
        problems.add(("driven",), "driven and not driven", got, "one of them")
    if recording.map.driven and not drives and not moved:
        near = (n for n in recording.channels if n not in known and get_close_matches(n, known, 1))
        alone = "driven = false of an axis let alone (coast-down, free decay)"
        right = f"{one_of(known, next(near, None))}; {alone}"
        there = ", ".join(n for n, c in recording.channels.items() if not c.summed)
        problems.add(("channels",), "no channel of what drives the axis", there, right)
    problems.raise_if_any()


def _check_motor(recording: Recording, declared: Scenario) -> None:
    """Check that the recorded drive is what the model's motor takes: amperes are no volts."""
    loads = [type(load) for load in declared.loads]
    motor = next((name for name, (kind, _) in MOTORS.items() if kind in loads), None)
    signals = AxisSignals()
    signal = next((d for d in signals.drive if d in recording.channels), None)
    if motor is None or signal is None or recording.channels["position"].role == "input":
        return
    problems = Problems(recording.map.source)
    if signals.supplied(recording):
        signal = signals.supply
    elif signal == "duty" and motor == "voltage-drive" and recording.channels[signal].unit in PLAIN:
        right = 'a channel "supply" beside it, in V; or a load of kind force-drive in the model'
        what = f"a part of the supply, and the model's {motor} takes volts"
        problems.add(("channels", signal), what, "no channel of the supply", right)
        problems.raise_if_any()
    unit = recording.channels[signal].unit
    takers = [name for name, (_, kinds) in MOTORS.items() if any(is_unit(unit, k) for k in kinds)]
    if unit in PLAIN or motor in takers:
        return
    right = " or ".join(DIMENSIONS[kind].si for kind in MOTORS[motor][1])
    if takers:
        right += f"; or a load of kind {takers[0]} in the model"
    for seen in (n.removeprefix(SEEN) for n in signals.seen if n in recording.channels):
        right += f'; or role = "input" of channel {seen}, and no channel {signal}'
    problems.add(("channels", signal, "unit"), f"not what the model's {motor} takes", unit, right)
    problems.raise_if_any()


def _check_every_row(recording: Recording) -> None:
    """What drives an axis, and where it is, must be known in every row that is predicted."""
    problems = Problems(recording.map.source)
    for name in filter(None, (AxisSignals().driving(recording), "position")):
        for run in recording.runs:
            none = ~np.isfinite(run.channels.get(name, np.zeros(0)))
            if none.any():
                where = recording.channels[name].where
                column = "its column" if where is None else where[0]
                right = (
                    f"one in every row: name {column} in [runs] boundaries, which ends a run where "
                    "it changes, and in [only], which leaves other runs out"
                )
                what, got = "no value in some rows", f"{none.sum()} of {none.size} in {run.name}"
                problems.add(("channels", name, "where"), what, got, right)
                break
    problems.raise_if_any()


def _check_moving(recording: Recording) -> None:
    """Something must move, driven by something, and be sampled fast enough to see it."""
    problems = Problems(recording.source)
    for name in (*AxisSignals().drive, "position"):
        # Beside the rows in which a channel applies there is nothing of it: see `_check_every_row`.
        known = [r.channels[name] for r in recording.runs if name in r.channels]
        seen = [values[np.isfinite(values)] for values in known if np.isfinite(values).any()]
        set_once = name != "position" and seen and recording.channels[name].held != "sampled"
        if seen and not set_once and not any(np.ptp(values) > 0.0 for values in seen):
            what = f"{name} is the same in every row of every run"
            value = recording.channels[name].written(seen[0][0])
            right = "a live sensor, the right column"
            if name != "position" and recording.channels[name].role == "input":
                right += (
                    "; `held` in the map, if it was set and holds; of an axis let alone no such "
                    "channel, and driven = false in the map"
                )
            problems.add((), what, value, right)
    longest, least = longest_run(recording), shortest(recording)
    if lasts(longest) < least:
        asked = "is the unit of time in the map right?"
        if (pieces := recording.map.pieces) > 1 and (most := most_pieces(recording)):
            asked = f"`pieces` in the map are too many: at most {most} of this run are long enough"
            if most < len(PARTS):
                whole = lasts(longest) * pieces
                asked = (
                    f"a run of {whole:.3g} s is too short for `pieces`: record a longer one, or "
                    "several"
                )
        right = f"at least {least:g} s; {asked}"
        problems.add((), "the longest run is too short", f"{lasts(longest):.3g} s", right)
    step = row_step(longest.time)
    # A run let alone is predicted whole.
    slowest = SLOWEST if recording.map.driven else SLOWEST_ALONE
    if recording.channels["position"].role != "input" and step > slowest * (1.0 + ROUNDING):
        what = "the axis is sampled too slowly for its friction to be seen"
        right = f"at most {slowest:g} s; is the unit of time in the map right?"
        problems.add((), what, f"{step:.3g} s a sample", right)
    problems.raise_if_any()


def _check_played(recording: Recording, declared: Scenario) -> None:
    """A record is played at the model's rate: at a far lower one most of the drive is lost.

    At a far higher one a run takes hours: rows of milliseconds were called seconds.
    """
    step = usual_step(recording)
    moved = recording.channels["position"].role == "input"
    if moved and step > MOST_BETWEEN * declared.period > 0.0:
        problems = Problems(declared.name)
        what = f"the record has a row every {step:.4g} s, far apart for this rate"
        right = f"some {10.0 / step:.2g} Hz; or is the unit of time in the map right?"
        got = f"{1.0 / declared.period:.4g} Hz"
        problems.add(("controller", "rate"), what, got, right, where=declared.name)
        problems.raise_if_any()
    if not moved and recording.map.driven:
        check_rate(recording, declared)


def _check_closed(recording: Recording, declared: Scenario) -> None:
    """Some row must switch the friction on; one without a value tells nothing."""
    pressed = [r.channels["pressure"] for r in recording.runs if "pressure" in r.channels]
    known = [values[np.isfinite(values)] for values in pressed]
    most = max((float(values.max()) for values in known if values.size), default=0.0)
    problems = Problems(declared.name)
    for k, clutch in enumerate(declared.clutches):
        if clutch.threshold >= most:
            what = f"never on in this recording (its command is at most {most:g} V), no friction"
            right = 'less, e.g. "-1 V" for friction that is always there'
            path = ("clutch", k + 1, "threshold")
            problems.add(path, what, f"{clutch.threshold:g} V", right, where=declared.name)
    problems.raise_if_any()
