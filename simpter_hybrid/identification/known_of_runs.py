"""Constants of runs that a map adds to parameters of the model: another weight hung on."""

from __future__ import annotations

from typing import Any

from ..problems import Problems
from ..reading.fields import resolved
from ..reading.reader import one_of
from ..scenario import Scenario
from ..units import QuantityError, parse_quantity
from .recordings.recording import Recording

#: How names of parameters begin, and where a scenario has those parts; loads are none, for a record
#: takes the place of some.
PARTS = {"device": "device", "clutch": "clutches", "effect": "effects"}


def check_known(recording: Recording, declared: Scenario) -> None:
    """Check that the model has each parameter to which a constant of runs is added.

    Raises
    ------
    InvalidInput
        If it has none of that name or one of another unit, or if what is added is no constant of
        runs or is added twice.
    """
    problems = Problems(recording.map.source)
    of_parts = (n for n in declared.parameter_names() if n.partition(".")[0] in PARTS)
    names = [n for n in of_parts if n.startswith("device.") or dimension_of(declared, n)]
    columns: dict[tuple[str, str], str] = {}
    for signal, channel in recording.channels.items():
        name, where = channel.adds_to, ("channels", signal)
        if not name:
            continue
        if channel.role != "constant":
            right = 'role = "constant"'
            problems.add((*where, "adds_to"), "not a constant of runs", channel.role, right)
        elif (run := _varies(signal, recording)) is not None:
            what, right = "another value in one row than in the next", "one number for each run"
            problems.add((*where, "column"), what, f"{channel.column} of {run}", right)
        first = columns.setdefault((channel.column, name), signal)
        if first != signal:
            right = "each column once"
            problems.add((*where, "adds_to"), f"channels.{first} adds it already", name, right)
        if name not in names:
            what = "no parameter of the model"
            problems.add((*where, "adds_to"), what, name, one_of(names, name))
        elif dimension := dimension_of(declared, name):
            try:
                parse_quantity(f"1 {channel.unit}", dimension)
            except QuantityError as error:
                what = f"{error.what}, of {name}"
                problems.add((*where, "unit"), what, channel.unit, error.right)
    problems.raise_if_any()


def _varies(signal: str, recording: Recording) -> str | None:
    """Name of the first run in which a channel changes; None if there is none."""
    known = (r for r in recording.runs if signal in r.channels)
    return next(
        (r.name for r in known if (r.channels[signal] != r.channels[signal][0]).any()), None
    )


def dimension_of(declared: Scenario, name: str) -> str:
    """What a parameter measures; "" where its part does not say."""
    kind, *path = name.split(".")
    part: Any = getattr(declared, PARTS[kind])
    if kind != "device":
        part = part[int(path.pop(0)) - 1]
    if path[0] == "torque":
        part = part.torque
    fields = getattr(type(part), "__dataclass_fields__", {})
    if path[-1] not in fields:
        return ""
    dimension = fields[path[-1]].metadata.get("dimension", "")
    return resolved(dimension, declared.device, int(getattr(part, "coordinate", 0)))
