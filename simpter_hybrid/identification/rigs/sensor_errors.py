"""Errors of a rig's sensors in a scenario's ``[readings]``: those declared, and those found."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace

from ...measuring.readings import Channel, Readings
from ...problems import InvalidInput, Problem
from ...scenario import Scenario
from ...sensor import Sensor

#: A signal of the readings, and ``gain``, ``offset``, ``delay``, ``average`` or ``filter`` of the
#: sensor.
Key = tuple[str, str]
#: How often a new sensor is read where a model has no controller [s].
READ = 1e-3
#: The angle by which a tip's force is shown turned.
TURNED: Key = ("tip force", "turned")
#: Parts of a tip's force along the other axis that each of its axes shows.
CROSSTALK: tuple[Key, Key] = ("tip force", "crosstalk x"), ("tip force", "crosstalk y")


def told_errors(scenario: Scenario, known: Collection[Key]) -> dict[Key, float]:
    """Errors of sensors in a scenario's readings [SI]; a clock that is ahead is a negative delay.

    Noise and steps are none: a recording's own map says them.

    Raises
    ------
    InvalidInput
        If a sensor has an error that is not among those `known` to a rig.
    """
    readings = scenario.notes.get("readings")
    if readings is None:
        return {}
    axes = zip(
        (TURNED, *CROSSTALK), (readings.force_turned, *readings.force_crosstalk), strict=True
    )
    stated = [(key, amount) for key, amount in axes if amount]
    for channel in readings.channels:
        stated += _errors(channel)
    found: dict[Key, float] = {}
    problems = []
    right = ", ".join(f"{field} of {signal!r}" for signal, field in known) or "none on this rig"
    for key, amount in stated:
        if key in known and key not in found:
            found[key] = amount
            continue
        what = f"{key[1]} cannot be taken into account here (or stands twice)"
        where = f"readings: {key[0]}"
        problems.append(Problem(scenario.name, where, what, f"{amount:g}", right))
    if problems:
        raise InvalidInput(problems)
    return found


def told_values(scenario: Scenario, known: Mapping[Key, str]) -> dict[str, float]:
    """Declared errors of sensors under the names that a fit has for them [SI].

    Raises
    ------
    InvalidInput
        As `told_errors` does.
    """
    return {known[key]: amount for key, amount in told_errors(scenario, known).items()}


def stated_errors(values: Mapping[str, float], known: Mapping[Key, str]) -> dict[Key, float]:
    """Fitted errors of sensors, by signal and field as ``[readings]`` state them [SI]."""
    return {key: values.get(name, 0.0) for key, name in known.items()}


def _errors(channel: Channel) -> list[tuple[Key, float]]:
    sensor = channel.sensor
    signal = f"differentiated {channel.signal}" if channel.differentiated else channel.signal
    amounts = {"delay": sensor.delay - sensor.clock_shift}
    amounts |= {field: getattr(sensor, field) for field in ("gain", "offset", "average", "filter")}
    amounts["clock_rate"] = sensor.clock_rate
    return [((signal, field), amount) for field, amount in amounts.items() if amount]


def with_errors(scenario: Scenario, errors: Mapping[Key, float]) -> Scenario:
    """The scenario whose readings have these errors.

    Channels that it has keep their noise; one that is new is read at the controller's rate.
    """
    readings = scenario.notes.get("readings") or Readings(scenario.period or READ, ())
    channels = {c.signal: k for k, c in enumerate(readings.channels) if not c.differentiated}
    made = list(readings.channels)
    turned = float(errors.get(TURNED, readings.force_turned))
    x, y = (
        float(errors.get(key, told))
        for key, told in zip(CROSSTALK, readings.force_crosstalk, strict=True)
    )
    for signal in dict.fromkeys(key[0] for key in errors if key not in (TURNED, *CROSSTALK)):
        own = {field: float(amount) for (s, field), amount in errors.items() if s == signal}
        if (late := own.pop("delay", None)) is not None:
            own |= {"delay": max(late, 0.0), "clock_shift": max(-late, 0.0)}
        if signal in channels:
            at = channels[signal]
            made[at] = replace(made[at], sensor=replace(made[at].sensor, **own))  # type: ignore[arg-type]
        elif any(own.values()):
            made.append(Channel(signal, Sensor(**own)))  # type: ignore[arg-type]
    readings = replace(readings, channels=tuple(made), force_turned=turned, force_crosstalk=(x, y))
    return replace(scenario, notes={**scenario.notes, "readings": readings})
