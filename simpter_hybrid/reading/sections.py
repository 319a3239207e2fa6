"""The sections of a scenario file, each read into what ``Scenario`` takes."""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import lru_cache
from pathlib import Path
from typing import Any

from ..applied_load import Load
from ..checks.effect_check import place_of
from ..controller import Controller
from ..device import Device, wrong_dimensions
from ..devices.pter import Pter
from ..effect import Effect
from ..units import format_quantity, parse_quantity
from .additions import KEY, NUMBERS, read_additions, read_numbers
from .beside import texts_beside
from .fields import Context, build, coordinate_kind, read_kind, read_part
from .reader import TableReader

RATE_LIMIT = "100 kHz"


@lru_cache(maxsize=1)
def pter_defaults() -> dict[str, float]:
    """PTER's nominal parameters [SI], from ``devices/pter_parameters.toml``."""
    from tomllib import loads

    file = Path(__file__).parents[1] / "devices" / "pter_parameters.toml"
    entries = loads(file.read_text(encoding="utf-8"))["linkage"]
    return {name: parse_quantity(e["value"], e["dimension"]) for name, e in entries.items()}


def read_device(table: TableReader, folder: Path) -> tuple[Device | None, dict[str, Any]]:
    """``[device]``; the notes it leaves in the scenario (where a function made it) come second."""
    found = read_kind(table, "device", folder)
    if found is None:
        return None, {}
    if isinstance(found, type):
        defaults = pter_defaults() if issubclass(found, Pter) else {}
        made = build(table, found, Context(folder, defaults=defaults))
        return read_additions(table, _measured(table, made)), {}  # type: ignore[arg-type]
    given = {key: table.raw(key) for key in table.data if key not in ("kind", KEY, NUMBERS)}
    try:
        device = found(**given)
    except (Exception, SystemExit) as error:  # whatever the user's function does
        what = f"the function failed ({type(error).__name__}: {error})"
        table.problem("kind", what, "a function that takes the table's other keys")
        return None, {}
    if not isinstance(device, Device):
        table.problem("kind", f"the function returned a {type(device).__name__}", "a Device")
        return None, {}
    if _measured(table, device) is None:
        return None, {}
    kind = table.data["kind"]
    notes = {
        "device": {"kind": kind, **given},
        "device numbers": device.parameters(),
        "device modules": texts_beside(found, kind.partition(":")[0]),
    }
    return read_additions(table, read_numbers(table, device)), notes


def _measured(table: TableReader, device: Any) -> Any:
    """The device, if it says what its coordinates measure: by that all other sections are read."""
    wrong = device and wrong_dimensions(device.coordinate_dimensions, device.n)
    if not wrong:
        return device
    said = f"{type(device).__name__}.coordinate_dimensions {device.coordinate_dimensions}"
    return table.problem("kind", f"{said}: {wrong[0]}", wrong[1])


def read_controller(
    root: TableReader, device: Device | None, folder: Path, path: Mapping[str, float]
) -> tuple[tuple[tuple[Controller, int], ...], float]:
    """``[controller]``: its stages with the periods between their samples, and the base period."""
    if "controller" not in root:
        root.table("controller", {})
        return (), 0.0
    table = root.table("controller")
    if "period" in table:
        period = table.quantity("time", "period", min="10 us", max="1 h")
        if "rate" in table:
            table.problem("rate", "a period is given as well", "rate or period")
            table.raw("rate")
    else:
        rate = table.quantity("frequency", "rate", min="1e-3 Hz", max=RATE_LIMIT)
        period = 1.0 / rate if rate else math.nan
    context = Context(folder, device, path)
    stages: list[tuple[Controller, int]] = []
    for each in table.tables("stages"):
        every = each.integer("every", 1, min=1, max=1_000_000)
        stage = read_part(each, "controller", context)
        if isinstance(stage, Controller):
            stages.append((stage, every))
    return tuple(stages), period


def read_list(root: TableReader, key: str, family: str, context: Context) -> tuple[Any, ...]:
    """An array of parts, as ``[[loads]]`` and ``[[stops]]``."""
    found = [read_part(table, family, context) for table in root.tables(key, ())]
    return tuple(part for part in found if part is not None)


def read_loads(root: TableReader, context: Context) -> tuple[Load, ...]:
    """``[[loads]]``."""
    return read_list(root, "loads", "load", context)


def read_effects(root: TableReader, context: Context) -> tuple[Effect, ...]:
    """``[[effects]]``, each attached to what its ports need."""
    found = []
    for table in root.tables("effects", ()):
        effect = read_part(table, "effect", context)
        if not isinstance(effect, Effect):
            continue
        place = place_of(effect)
        if place == "clutch" and "clutch" not in table:
            table.problem("clutch", "missing", "the number, from 1, of the clutch it acts on")
        if place == "coordinate" and "coordinate" not in table:
            known = ", ".join(context.device.coordinates) if context.device is not None else ""
            table.problem("coordinate", "missing", f"the coordinate it acts on: {known}")
        other = "coordinate" if place == "clutch" else "clutch"
        if place and other in table:
            table.problem(other, f"an effect on a {place}", f"no such key, only {place}")
        found.append(effect)
    return tuple(found)


def read_path(root: TableReader) -> dict[str, float]:
    """``[path]``: the numbers of the tip's desired path, by the names controllers give them."""
    if "path" not in root:
        root.table("path", {})
        return {}
    table = root.table("path")
    if table.choice("kind", ["line", "circle"]) == "circle":
        x, y = table.vector("length", "centre", 2)
        return {"x": x, "y": y, "radius": table.quantity("length", "radius", above=0.0)}
    x, y = table.vector("length", "point", 2)
    return {"x": x, "y": y, "angle": table.quantity("angle", "angle")}


def read_tolerances(root: TableReader) -> list[dict[str, Any]]:
    """``[[tolerances]]``: how well groups of parameters are known, for ``simpter diagnose``."""
    found: list[dict[str, Any]] = []
    for table in root.tables("tolerances", ()):
        names = table.texts("parameters")
        if not names:
            table.problem("parameters", "no parameter", 'at least one, as "device.mass"')
        name = table.text("name", ", ".join(names))
        relative = table.number("relative", above=0.0, max=10.0)
        if any(name == other["name"] for other in found):
            table.problem("name", "the name of another group", "a name of its own")
        found.append({"name": name, "parameters": names, "relative": relative})
    return found


def read_start(root: TableReader, device: Device | None) -> dict[str, tuple[float, ...]]:
    """``[start]``: coordinates, speeds, commands and excitations."""
    table = root.table("start")
    n, m = (device.n, device.m) if device is not None else (None, None)
    kinds = [coordinate_kind(device, j) for j in range(n or 0)]
    if "tip" in table:
        q = _pose(table, device)
    elif n is None:
        q = table.raw("coordinates", ())
    else:
        q = _vector(table, "coordinates", kinds, None)
    names = {"angle": "angular_speed", "length": "speed"}
    if n is None:
        qd = table.raw("speeds", ())
    else:
        qd = _vector(table, "speeds", [names[k] for k in kinds], (0.0,) * n)
    command = table.vector("voltage", "commands", m, ())
    excitation = table.vector("voltage", "excitations", m, ())
    return {
        "q": tuple(q),
        "qd": tuple(qd),
        "command": tuple(command),
        "excitation": tuple(excitation),
    }


def _vector(table: TableReader, key: str, kinds: list[str], default: Any) -> tuple[float, ...]:
    """An array with one quantity a coordinate."""
    if key not in table and default is not None:
        table.raw(key, default)
        return default
    if len(set(kinds)) == 1:
        return tuple(table.vector(kinds[0], key, len(kinds)))
    values = table.texts(key, len(kinds))
    found = []
    for j, (value, kind) in enumerate(zip(values, kinds, strict=False)):
        inner = TableReader({str(j): value}, table.problems, (*table.path, key))
        found.append(inner.quantity(kind, str(j)))
    return tuple(found)


def _pose(table: TableReader, device: Device | None) -> tuple[float, ...]:
    """Coordinates that put the tip at ``tip`` with the elbow to the side ``elbow``."""
    before = len(table.problems)
    x, y = table.vector("length", "tip", 2)
    elbow = table.choice("elbow", ["positive", "negative"], "positive")
    if "coordinates" in table:
        table.problem("coordinates", "the tip is given as well", "tip or coordinates")
        table.raw("coordinates")
    if device is None or len(table.problems) > before:
        return ()
    pose = getattr(device, "pose", None)
    if pose is None:
        what = f"{type(device).__name__} has no inverse kinematics"
        table.problem("tip", what, "coordinates = [...] in place of tip")
        return ()
    found = pose(x, y, elbow == "positive")
    if found is None:
        near, far = (format_quantity(r, "m") for r in device.reach)  # type: ignore[attr-defined]
        away = f"out of reach, at {math.hypot(x, y):.6g} m from the origin"
        table.problem("tip", away, f"a point from {near} to {far} from the origin")
        return ()
    return tuple(found)
