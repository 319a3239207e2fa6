"""List the scenarios that come with the program, or the parts that a scenario may use."""

from __future__ import annotations

import argparse
import inspect
import re
from functools import cache
from pathlib import Path
from typing import Any

from . import DONE

HELP = "list the shipped scenarios, with --parts what scenarios are made of"


def arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument(
        "--parts", action="store_true", help="the kinds of parts, and the keys each one takes"
    )
    parser.add_argument("--json", action="store_true", help="data on stdout")


def execute(args: argparse.Namespace) -> int:
    """Print names and what they are about."""
    from ..files.scenario_file import shipped_scenarios

    if args.parts:
        found = _parts()
    else:
        found = [_scenario(name, file) for name, file in shipped_scenarios().items()]
    if args.json:
        import json

        print(json.dumps(found, indent=2))
        return DONE
    width = max(len(entry["name"]) for entry in found)
    for entry in found:
        print(f"{entry['name']:<{width}}  {entry['about']}")
        for line in entry.get("keys", ()):
            print(f"    {line}")
    return DONE


def _scenario(name: str, file: Path) -> dict[str, Any]:
    from tomllib import loads

    data = loads(file.read_text(encoding="utf-8"))
    about = f"{data.get('about', '')} [{data.get('answers_to', '')}]"
    return {"name": name, "about": about, "file": str(file)}


def _parts() -> list[dict[str, Any]]:
    import dataclasses

    from ..reading.kinds import FAMILIES, shipped

    return [
        {
            "name": f"{family} {kind}",
            "about": _about(cls),
            "keys": [
                _told(line, f.name, cls)
                for f in dataclasses.fields(cls)
                if f.name not in _elsewhere(family, cls) and (line := _key(f, cls))
            ],
        }
        for family in FAMILIES
        for kind, cls in shipped(family).items()
    ] + [_additions()]


def _elsewhere(family: str, cls: type) -> tuple[str, ...]:
    """Keys of all effects that this one does not take: it acts on a clutch or on a coordinate."""
    from ..checks.effect_check import place_of

    place = place_of(cls) if family == "effect" else ""
    return tuple(key for key in ("clutch", "coordinate") if place and key != place)


def _about(cls: type) -> str:
    """The first sentence on a part."""
    text = " ".join((cls.__doc__ or "").split("\n\n")[0].split())
    return re.split(r"(?<=[.;])\s+(?=[A-Z`])", text)[0]


def _told(line: str, name: str, cls: type) -> str:
    """A key and what it takes, then what its class says of it, where that counts as files do."""
    meaning = _meanings(cls).get(name, "")
    meaning = "" if "from 0" in meaning else meaning
    return f"{line}: {meaning}" if meaning else line


@cache
def _meanings(cls: type) -> dict[str, str]:
    """Parameter -> what a class's docstring says of it, units left out."""
    section = (inspect.getdoc(cls) or "").partition("Parameters\n----------\n")[2].split("\n\n")[0]
    found: dict[str, str] = {}
    names: list[str] = []
    for line in section.splitlines():
        if line[:1].strip():
            names = [name.strip() for name in line.partition(" : ")[0].split(",")]
            continue
        for name in names:
            found[name] = f"{found.get(name, '')} {line.strip()}"
    plain = {name: re.sub(r"\s*\[[^]]*\]", "", text) for name, text in found.items()}
    return {name: " ".join(text.split()).rstrip(".") for name, text in plain.items()}


def _additions() -> dict[str, Any]:
    """What ``[[device.with]]`` takes."""
    from ..devices.extended import UNITS
    from ..reading.additions import KEY, KINDS
    from ..units import expected_quantity

    keys = [f"kind = one of {', '.join(KINDS)}", "clutch = number, from 1, of a clutch"]
    keys.append("name = of the new coordinate (of the new surface: drag) [its kind]")
    for key, units in UNITS.items():
        keys.append(f"{key} = {expected_quantity(units['angle'])} (not for drag)")
    about = f"What a file adds to any device, [[device.{KEY}]], one after the other."
    return {"name": f"device {KEY}", "about": about, "keys": keys}


def _key(f: Any, cls: type) -> str:
    """``stiffness = a stiffness with its unit, e.g. "32 lbf/in"``."""
    import dataclasses

    from ..devices.pter import Pter
    from ..known_units import BY_COORDINATE
    from ..units import expected_quantity, format_quantity, si_unit

    if "columns" in f.metadata:
        named = [
            (name, BY_COORDINATE.get(d, {}).get("angle", d)) for name, d in f.metadata["columns"]
        ]
        rows = ", ".join(f"{name} ({si_unit(d) or 'number'})" for name, d in named)
        names = ", ".join(f'"{name}"' for name, _ in named)
        units = ", ".join(f'"{si_unit(d)}"' for _, d in named)
        series = f'{{ file = "my.csv", columns = [{names}], units = [{units}] }}'
        return f"{f.name} = rows of [{rows}], or {series}"
    if "index" in f.metadata or f.name in ("clutch", "coordinate"):
        kind = f.metadata.get("index", f.name)
        return f"{f.name} = {'number, from 1,' if kind == 'clutch' else 'name'} of a {kind}"
    dimension = f.metadata.get("dimension", "dimensionless")
    dimension = BY_COORDINATE.get(dimension, {}).get("angle", dimension)
    unit = si_unit(dimension)
    text = f"{f.name} = {expected_quantity(dimension)}"
    if f.default is not dataclasses.MISSING and isinstance(f.default, float):
        shown = format_quantity(f.default, unit) if unit else f"{f.default:g}"
        return f"{text} [{shown}]"
    return f"{text} [nominal]" if issubclass(cls, Pter) else text
