"""``[readings]``: sensors that a file puts on signals of its run."""

from __future__ import annotations

from typing import Any

from ..device import Device
from ..measuring.readings import Channel, Readings, signals
from ..sensor import Sensor
from ..units import format_quantity, si_unit
from .reader import TableReader

#: Parameters of a sensor in the signal's own unit, and those that are times or shares.
OWN, TIMES, SHARES = ("offset", "noise", "step"), ("delay", "average", "filter", "clock_shift"), (
    "gain", "clock_rate"
)  # fmt: skip


def read_readings(root: TableReader, device: Device | None) -> Readings | None:
    """``[readings]`` with its ``[[readings.sensors]]``; None if the file has none."""
    if "readings" not in root:
        root.table("readings", {})
        return None
    table = root.table("readings")
    rate = table.quantity("frequency", "rate", min="1e-3 Hz", max="100 kHz")
    turned = table.quantity("angle", "force_turned", 0.0)
    crosstalk = table.vector("dimensionless", "force_crosstalk", 2, [0.0, 0.0])
    no_tip = device is not None and "tip_jacobian" not in device.functions()
    for name, given in (("force_turned", turned), ("force_crosstalk", any(crosstalk))):
        if given and no_tip:
            table.problem(name, "the device has no tip", "a device with a tip, or nothing")
    found = [_channel(each, device) for each in table.tables("sensors")]
    channels = tuple(channel for channel in found if channel is not None)
    return Readings(1.0 / rate, channels, turned, (crosstalk[0], crosstalk[1]))


def _channel(table: TableReader, device: Device | None) -> Channel | None:
    before = len(table.problems)
    known = signals(device) if device is not None else {}
    signal = table.choice("signal", known) if known else table.text("signal")
    values: dict[str, Any] = {}
    for name in OWN:
        if not known or signal not in known:
            table.raw(name, 0.0)
            continue
        least = None if name == "offset" else 0.0
        values[name] = table.quantity(known[signal].dimension, name, 0.0, min=least)
    for name in TIMES:
        least = None if name == "clock_shift" else 0.0
        values[name] = table.quantity("time", name, 0.0, min=least)
    for name in SHARES:
        values[name] = table.number(name, 0.0, above=-1.0)
    values["seed"] = table.integer("seed", 0, min=0, max=4_000_000_000)
    differentiated = table.boolean("differentiated", False)
    speed_filter = table.quantity("time", "speed_filter", 0.0, min=0.0)
    if device is None or len(table.problems) > before:
        return None
    return Channel(signal, Sensor(**values), differentiated, speed_filter)


def written(readings: Readings, device: Device) -> dict[str, Any]:
    """``[readings]`` as a file writes it; what is 0 is left out."""
    known = signals(device)
    sensors = []
    for channel in readings.channels:
        sensor = channel.sensor
        units = dict.fromkeys(OWN, si_unit(known[channel.signal].dimension))
        units |= dict.fromkeys(TIMES, "s")
        table: dict[str, Any] = {"signal": channel.signal}
        for name in (*OWN, *TIMES, *SHARES):
            if value := getattr(sensor, name):
                table[name] = format_quantity(value, units[name]) if name in units else value
        table["seed"] = sensor.seed
        if channel.differentiated:
            table["differentiated"] = True
            table["speed_filter"] = format_quantity(channel.speed_filter, "s")
        sensors.append(table)
    found: dict[str, Any] = {"rate": format_quantity(1.0 / readings.period, "Hz")}
    if readings.force_turned:
        found["force_turned"] = format_quantity(readings.force_turned, "rad")
    if any(readings.force_crosstalk):
        found["force_crosstalk"] = list(readings.force_crosstalk)
    return found | {"sensors": sensors}
