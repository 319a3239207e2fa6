"""Devices with one thing more: a compliant shaft or mount, a drag that is always there."""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Sequence
from typing import NamedTuple

from ..derive import load_text
from ..device import Device
from ..part import arguments_of, source_of

HEAD = """import math
from dataclasses import dataclass
from math import *
from typing import ClassVar

from simpter_hybrid.device import Device
from simpter_hybrid.part import parameter


"""


#: What a shaft or a mount has, and its dimension where its clutch turns and where it slides.
UNITS = {
    "inertia": {"angle": "inertia", "length": "mass"},
    "stiffness": {"angle": "rotational_stiffness", "length": "stiffness"},
    "damping": {"angle": "rotational_damping", "length": "damping"},
}


class Addition(NamedTuple):
    """What an extended device has beyond the one it was made from.

    Its class carries them as ``additions``, and the class it began with as ``extends``.
    """

    kind: str
    clutch: int
    name: str


def with_shaft(
    device: Device,
    clutch: int,
    inertia: float,
    stiffness: float = 0.0,
    damping: float = 0.0,
    name: str = "shaft",
) -> Device:
    """The device with a shaft between its motion and clutch number ``clutch`` (from 0).

    A new coordinate is the shaft's wind-up: the clutch's side lags behind the device by it and has
    an ``inertia`` of its own.  With ``stiffness`` 0 and ``effects.backlash`` on that coordinate the
    shaft is a gear with play.

    Parameters
    ----------
    device : Device
        With a constant clutch map and without tables.
    clutch : int
        From 0.
    inertia : float
        Of the clutch's side [kg m^2; kg if the clutch rubs along a length].
    stiffness, damping : float
        Of the shaft [N m/rad, N m s/rad; N/m, N s/m].
    name : str
        Of the coordinate.

    Raises
    ------
    ValueError
        If the device cannot be extended.
    """
    added = Addition("shaft", clutch, name)
    return _extended(device, added, inertia, stiffness, damping)


def with_mount(
    device: Device,
    clutch: int,
    inertia: float,
    stiffness: float,
    damping: float = 0.0,
    name: str = "mount",
) -> Device:
    """The device with the other half of clutch number ``clutch`` (from 0) on a spring to ground.

    As a coil that stands on a torque sensor (thesis (40)-(42)): the new coordinate is the mount's
    angle, the sensor reads ``stiffness`` times it.

    Parameters
    ----------
    device, clutch, inertia, stiffness, damping, name
        As for ``with_shaft``, of the mount in place of the shaft; errors are the same.
    """
    added = Addition("mount", clutch, name)
    return _extended(device, added, inertia, stiffness, damping)


def with_drag(device: Device, clutch: int, name: str = "drag") -> Device:
    """The device with one more friction surface beside clutch number ``clutch`` (from 0).

    For what a clutch leaves when it is off: bearings, residual magnetism, a magnetorheological
    fluid.  Describe the new, last surface by a clutch that is always engaged.

    Parameters
    ----------
    device : Device
        Without tables.
    clutch : int
        From 0.
    name : str
        Of the surface.

    Raises
    ------
    ValueError
        If there is no such clutch, the name is taken, or the device has tables.
    """
    n, m = device.n, device.m
    added = Addition("drag", clutch, name)
    text, functions = _begin(device, added)
    for each in functions:
        if each == "clutch_map":
            lines = [f"out[{m * n + j}] = out[{clutch * n + j}]" for j in range(n)]
        elif each == "clutch_map_rate":
            lines = [f"out[{m}] = out[{clutch}]"]
        else:
            lines = []
        text += _function(device, each, lines)
    return _object(text, device, added)


def _extended(
    device: Device, added: Addition, inertia: float, stiffness: float, damping: float
) -> Device:
    n, m, p = device.n, device.m, list(device.parameters().values())
    kind, clutch, name = added
    row = [*_row(device, clutch), -1.0]
    along = slips_along(device, clutch)
    values = {"inertia": inertia, "stiffness": stiffness, "damping": damping}
    own = [(f"{name}_{key}", UNITS[key][along], value) for key, value in values.items()]
    text, functions = _begin(device, added, own, along)
    k = len(p)
    spread = _spread(n, n)
    if kind == "mount":
        more = [f"out[{n * (n + 1) + n}] = p[{k}]"]
    else:
        more = [
            f"out[{a * (n + 1) + b}] += {row[a] * row[b]!r} * p[{k}]"
            for a in range(n + 1)
            for b in range(n + 1)
            if row[a] * row[b] != 0.0
        ]
    bodies = {
        "mass_matrix": [*spread, *(f"out[{n * (n + 1) + b}] = 0.0" for b in range(n + 1)), *more],
        "velocity_terms": [f"out[{n}] = 0.0"],
        "damping_force": [f"out[{n}] = -p[{k + 2}] * qd[{n}]"],
        "clutch_map": [*_spread(m, n), f"out[{clutch * (n + 1) + n}] = -1.0"],
        "clutch_map_rate": [],
        "conservative_force": [f"out[{n}] = -p[{k + 1}] * q[{n}]"],
        "tip_jacobian": _spread(2, n),
    }
    for each in functions:
        text += _function(device, each, bodies.get(each, []))
    for each, words in (("conservative_force", "q, p, out"), ("damping_force", "q, qd, p, out")):
        if each not in functions:
            lines = [*(f"out[{j}] = 0.0" for j in range(n)), *bodies[each]]
            text += f"    @staticmethod\n    def {each}({words}):\n"
            text += "".join(f"        {line}\n" for line in lines) + "\n"
    inner = f"{_inner(device)}potential_energy(q, p) + " if "potential_energy" in functions else ""
    if inner or "conservative_force" not in functions:
        text += "    @staticmethod\n    def potential_energy(q, p):\n"
        text += f"        return {inner}0.5 * p[{k + 1}] * q[{n}] * q[{n}]\n"
    return _object(text, device, added)


def _spread(count: int, n: int) -> list[str]:
    """Rows of n entries moved apart for one more column, last first; the column is 0."""
    lines = []
    for a in range(count - 1, -1, -1):
        lines.append(f"out[{a * (n + 1) + n}] = 0.0")
        lines += [f"out[{a * (n + 1) + b}] = out[{a * n + b}]" for b in range(n - 1, -1, -1) if a]
    return lines


def slips_along(device: Device, clutch: int) -> str:
    """``angle`` or ``length``: what clutch number ``clutch`` (from 0) slips along.

    Parameters
    ----------
    device : Device
    clutch : int
        From 0.

    Raises
    ------
    ValueError
        If it is some of both, there is no such clutch, or the clutch map is not constant.
    """
    kinds = device.coordinate_dimensions or ("angle",) * device.n
    row = zip(kinds, _row(device, clutch), strict=True)
    found = {kind for kind, entry in row if entry != 0.0}
    if len(found) > 1:
        raise ValueError(f"clutch {clutch} slips along lengths and angles: neither unit would do")
    return found.pop() if found else "angle"


def _row(device: Device, clutch: int) -> list[float]:
    """A row of a constant clutch map."""
    if not device.constant_clutch_map:
        raise ValueError(f"{type(device).__name__}: only constant clutch maps can be extended")
    if not 0 <= clutch < device.m:
        raise ValueError(f"clutch {clutch}: the device has {device.m}, counted from 0")
    n, p = device.n, list(device.parameters().values())
    out = [0.0] * (device.m * n)
    device.functions()["clutch_map"]([0.0] * n, p, out)
    return out[clutch * n : clutch * n + n]


def _check(device: Device, added: Addition) -> None:
    """Raise ValueError where the device cannot be extended like this."""
    kind, clutch, name = added
    if not 0 <= clutch < device.m:
        raise ValueError(f"clutch {clutch}: the device has {device.m}, counted from 0")
    if device.table():
        raise ValueError(f"{type(device).__name__}: a device with tables cannot be extended")
    if name in (*device.coordinates, *device.surfaces):
        raise ValueError(f"name {name!r}: the device has a coordinate or a surface of that name")
    if kind != "drag" and not re.fullmatch(r"[A-Za-z]\w*", name):
        raise ValueError(f"name {name!r}: no name that code can use; take letters, digits and _")


def _begin(
    device: Device, added: Addition, own: Sequence[tuple[str, str, float]] = (), along: str = ""
) -> tuple[str, list[str]]:
    """Module text up to the class's fields, and the names of its functions."""
    _check(device, added)
    functions = device.functions()
    inner = [source_of(f, f"{_inner(device)}{name}") for name, f in functions.items()]
    uses = [source_of(f, f.__name__) for f in device.uses]
    names = [*(f.__name__ for f in device.uses), *(f"{_inner(device)}{name}" for name in functions)]
    text = HEAD + "\n\n".join([*uses, *inner])
    text += "\n\n@dataclass(frozen=True)\nclass Extended(Device):\n"
    for f in dataclasses.fields(device):
        dimension = f.metadata.get("dimension", "dimensionless")
        text += f'    {f.name}: float = parameter("{dimension}", {getattr(device, f.name)!r})\n'
    for field, dimension, value in own:
        text += f'    {field}: float = parameter("{dimension}", {float(value)!r})\n'
    more, surfaces = ((added.name,), ()) if along else ((), (added.name,))
    kinds = device.coordinate_dimensions or ("angle",) * device.n
    text += f"    coordinates: ClassVar = {(*device.coordinates, *more)!r}\n"
    text += f"    coordinate_dimensions: ClassVar = {(*kinds, *(along for _ in more))!r}\n"
    text += f"    surfaces: ClassVar = {(*device.surfaces, *surfaces)!r}\n"
    text += f"    constant_clutch_map: ClassVar = {device.constant_clutch_map!r}\n"
    text += f"    uses: ClassVar = ({', '.join(names)},)\n\n"
    return text, list(functions)


def _inner(device: Device) -> str:
    """Prefix of the inner device's functions; extensions may be extended in turn."""
    depth = sum(f.__name__.endswith("_mass_matrix") for f in device.uses)
    return f"inner_{depth}_"


def _function(device: Device, name: str, lines: list[str]) -> str:
    """An inner function called, and what comes after it."""
    if name == "potential_energy":
        return ""
    words = ", ".join(arguments_of(device.functions()[name]))
    back = "" if "out" in words.split(", ") else "return "
    body = [f"{back}{_inner(device)}{name}({words})", *lines]
    text = f"    @staticmethod\n    def {name}({words}):\n"
    return text + "".join(f"        {line}\n" for line in body) + "\n"


def _object(text: str, device: Device, added: Addition) -> Device:
    begun = getattr(device, "extends", type(device))
    name = f"Extended{begun.__name__}"
    made = load_text(text.replace("class Extended(", f"class {name}("), name)
    made.extends = begun  # type: ignore[attr-defined]
    made.additions = (*getattr(device, "additions", ()), added)  # type: ignore[attr-defined]
    return made()
