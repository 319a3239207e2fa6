"""``[[device.with]]``: shafts, mounts and drag that a file adds to a device, one by one."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from typing import Any

from ..device import Device
from ..devices.extended import UNITS, slips_along, with_drag, with_mount, with_shaft
from ..units import format_quantity, si_unit
from .reader import TableReader

#: Key of the array of tables.
KEY = "with"
#: Key of the table of a device's numbers that a function's result is given in their place.
NUMBERS = "numbers"
SHAPES = {"shaft": with_shaft, "mount": with_mount}
KINDS = (*SHAPES, "drag")


def read_additions(table: TableReader, device: Device | None) -> Device | None:
    """The device with what ``[[device.with]]`` adds; None (and problems) if any of it is wrong."""
    for each in table.tables(KEY, ()):
        device = _added(each, device)
    return device


def _added(table: TableReader, device: Device | None) -> Device | None:
    before = len(table.problems)
    kind = table.choice("kind", KINDS)
    clutch = table.integer("clutch", min=1, max=device.m if device is not None else None) - 1
    name = table.text("name", kind)
    try:
        if kind == "drag":
            if device is None or len(table.problems) > before:
                return None
            return with_drag(device, clutch, name)
        along = slips_along(device, clutch) if device is not None else "angle"
        inertia = table.quantity(UNITS["inertia"][along], "inertia", above=0.0)
        stiffness = table.quantity(UNITS["stiffness"][along], "stiffness", 0.0, min=0.0)
        damping = table.quantity(UNITS["damping"][along], "damping", 0.0, min=0.0)
        if device is None or len(table.problems) > before:
            return None
        return SHAPES[kind](device, clutch, inertia, stiffness, damping, name)
    except ValueError as error:
        for key in UNITS:
            table.raw(key, None)  # known, though nothing was made of it
        right = "a clutch and a name with which it can be"
        table.problems.add(table.path, f"the {kind} cannot be added ({error})", name, right)
        return None


def read_numbers(table: TableReader, device: Device) -> Device:
    """A device that a function made, with the ``[device.numbers]`` of a file [SI] in place of its.

    So is written what was fitted: the function itself may know nothing of it.
    """
    if NUMBERS not in table:
        return device
    inner = table.table(NUMBERS)
    known = device.parameters()
    values = {name: inner.number(name, value) for name, value in known.items()}
    return dataclasses.replace(device, **values)


def begun_with(device: Device) -> Device:
    """The device without its additions, with the numbers that it has now."""
    begun = getattr(device, "extends", None)
    if begun is None:
        return device
    return begun(**{f.name: getattr(device, f.name) for f in dataclasses.fields(begun)})


def written(device: Device) -> dict[str, Any]:
    """``with`` of a device as a file writes it; empty where nothing was added."""
    units = {f.name: f.metadata.get("dimension", "") for f in dataclasses.fields(device)}
    found: list[dict[str, Any]] = []
    for kind, clutch, name in getattr(device, "additions", ()):
        table: dict[str, Any] = {"kind": kind, "clutch": clutch + 1, "name": name}
        for field in (f"{name}_{key}" for key in UNITS if kind != "drag"):
            key = field.removeprefix(f"{name}_")
            table[key] = format_quantity(getattr(device, field), si_unit(units[field]))
        found.append(table)
    return {KEY: found} if found else {}


def changed_numbers(device: Device, made: Mapping[str, float]) -> dict[str, Any]:
    """``numbers`` of a device that a function ``made`` with others; empty where none differs."""
    now = {
        name: getattr(device, name) for name, was in made.items() if getattr(device, name) != was
    }
    return {NUMBERS: now} if now else {}
