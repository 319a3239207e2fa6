"""A scenario written out in full: running it again reproduces the bytes."""

from __future__ import annotations

import dataclasses
import inspect
import sys
from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

from ..measuring.desired_path import Circle, Line
from ..part import Part
from ..reading import sensors
from ..reading.additions import begun_with, changed_numbers, written
from ..reading.beside import texts_beside
from ..reading.ends import written_without
from ..reading.fields import coordinate_kind, resolved
from ..reading.kinds import kind_of
from ..scenario import Scenario
from ..units import format_quantity, si_unit
from .provenance import labelled
from .tomlfile import dump_toml

#: Tables with more rows than this go to a CSV file beside the scenario.
LONGEST_TABLE = 40

HEAD = "# Every default filled in, SI units; running this reproduces the run's files.\n"


class Resolved(NamedTuple):
    """Text of ``scenario.toml``, and the files it names by their relative paths.

    `imported` are sources, by name, of modules of others that hold parts and can be imported from
    anywhere: they are not copied.
    """

    text: str
    files: dict[str, str]
    imported: Mapping[str, str] | None = None


def resolve(scenario: Scenario) -> Resolved:
    """Write a scenario out in full.

    Numbers are in SI units with all the digits that give back the same floats. Tables of more than
    40 rows become CSV files, unless their time stands still for a step; modules that stood beside
    the scenario's own file are copied.

    Parameters
    ----------
    scenario : Scenario

    Raises
    ------
    ValueError
        If a part cannot be written, e.g. a class made inside a function; if parts are of two
        modules of one name.
    """
    writer = _Writer(scenario)
    text = dump_toml(writer.document())
    return Resolved(
        HEAD + labelled(text, scenario.notes.get("inferred", ())), writer.files, writer.imported
    )


def document(scenario: Scenario) -> dict[str, Any]:
    """The tables of a scenario written out in full.

    Parameters
    ----------
    scenario : Scenario

    Raises
    ------
    ValueError
        See `resolve`.
    """
    return _Writer(scenario).document()


class _Writer:
    def __init__(self, scenario: Scenario) -> None:
        self.s = scenario
        self.files: dict[str, str] = {}
        self.imported: dict[str, str] = {}

    def document(self) -> dict[str, Any]:
        """The scenario's tables."""
        s = self.s
        found: dict[str, Any] = {"name": s.name}
        found |= {key: s.notes[key] for key in ("about", "answers_to", "units") if key in s.notes}
        if inferred := s.notes.get("inferred"):
            found["inferred"] = list(inferred)
        found["run"] = {
            "t_end": format_quantity(s.t_end, "s"),
            "method": s.method,
            "rtol": s.rtol,
            "atol": s.atol,
            "max_step": format_quantity(s.max_step, "s"),
            "event_limit": int(s.event_limit),
        }
        noted = s.notes.get("device")
        if noted:
            found["device"] = dict(noted)
        else:
            found["device"] = self.part(begun_with(s.device), "device", "device")
        found["device"] |= changed_numbers(s.device, s.notes.get("device numbers", {}))
        found["device"] |= written(s.device)
        if noted:
            module = str(noted["kind"]).partition(":")[0]
            self.module(module, s.notes.get("device modules"))
        found["start"] = self.start()
        found["clutches"] = [self.clutch(i) for i in range(len(s.clutches))]
        for key, family, parts in (
            ("loads", "load", s.loads), ("effects", "effect", s.effects), ("stops", "stop", s.stops)
        ):  # fmt: skip
            if parts:
                found[key] = [
                    self.part(p, family, f"{family}-{k + 1}") for k, p in enumerate(parts)
                ]
        found |= written_without(s.stops, s.device)
        if s.period > 0.0:
            stages = [
                self.part(stage, "controller", f"stage-{k + 1}") | {"every": every}
                for k, (stage, every) in enumerate(s.controllers)
            ]
            found["controller"] = {"period": format_quantity(s.period, "s"), "stages": stages}
        if tolerances := s.notes.get("tolerances"):
            found["tolerances"] = [dict(each) for each in tolerances]
        if readings := s.notes.get("readings"):
            found["readings"] = sensors.written(readings, s.device)
        if path := s.notes.get("path"):
            found["path"] = self.path(path)
        return found

    def start(self) -> dict[str, Any]:
        kinds = [coordinate_kind(self.s.device, j) for j in range(self.s.device.n)]
        at = {"angle": "rad", "length": "m"}
        per = {"angle": "rad/s", "length": "m/s"}
        m = self.s.device.m
        pairs = list(zip(self.s.q, self.s.qd, kinds, strict=True))
        return {
            "coordinates": [format_quantity(q, at[kind]) for q, _, kind in pairs],
            "speeds": [format_quantity(v, per[kind]) for _, v, kind in pairs],
            "commands": _volts(self.s.command or (0.0,) * m),
            "excitations": _volts(self.s.excitation or (0.0,) * m),
        }

    def clutch(self, i: int) -> dict[str, Any]:
        clutch = self.s.clutches[i]
        found = self.fields(clutch, f"clutch-{i + 1}")
        return found | {"torque": self.part(clutch.torque, "torque", f"clutch-{i + 1}")}

    def part(self, part: Part, family: str, name: str) -> dict[str, Any]:
        """``kind`` and fields of a part; ``name`` is for the files of its tables.

        Raises
        ------
        ValueError
            If the class was not defined at the top of a module that can be imported, or if another
            part is of another module of that name.
        """
        kind = kind_of(family, part)
        if "<locals>" in kind or kind.startswith("__main__:"):
            raise ValueError(
                f"{family} {type(part).__qualname__} cannot be written to a file: define the class "
                "at the top of a module that can be imported"
            )
        if ":" in kind:
            module = type(part).__module__
            self.module(module, texts_beside(type(part), module))
        return {"kind": kind} | self.fields(part, name)

    def fields(self, part: Part, name: str) -> dict[str, Any]:
        found: dict[str, Any] = {}
        for f in dataclasses.fields(part):
            value = getattr(part, f.name)
            if "columns" in f.metadata:
                at = self.number(part)
                columns = [(c, resolved(d, self.s.device, at)) for c, d in f.metadata["columns"]]
                found[f.name] = self.rows(value, columns, f"{name}-{f.name}")
            elif "index" in f.metadata or f.name in ("clutch", "coordinate"):
                if value >= 0:
                    kind = f.metadata.get("index", f.name)
                    found[f.name] = self.index(kind, int(value))
            elif f.type in ("float", float):
                # By the field's type: a part made in Python may have `delay=1`.
                unit = si_unit(self.dimension(part, f))
                found[f.name] = format_quantity(float(value), unit) if unit else float(value)
            elif isinstance(value, bool | int | str):
                found[f.name] = value
        return found

    def index(self, kind: str, number: int) -> int | str:
        return number + 1 if kind == "clutch" else self.s.device.coordinates[number]

    def dimension(self, part: Part, f: dataclasses.Field) -> str:
        dimension = f.metadata.get("dimension", "dimensionless")
        return resolved(dimension, self.s.device, self.number(part))

    def number(self, part: Part) -> int:
        """The coordinate that a part acts on."""
        return int(getattr(part, "coordinate", getattr(part, "index", 0)))

    def rows(self, rows: Sequence[Sequence[float]], columns: Sequence, name: str) -> Any:
        """A table in place, or the name of its CSV file."""
        units = [si_unit(dimension) for _, dimension in columns]
        # In a CSV file a time has to rise; in place it may stand still, for a step.
        steps = columns[0][1] == "time" and any(b[0] <= a[0] for a, b in pairwise(rows))
        if len(rows) <= LONGEST_TABLE or steps:
            return [
                [format_quantity(v, u) if u else v for v, u in zip(row, units, strict=True)]
                for row in rows
            ]
        names = [column.replace(" ", "_") for column, _ in columns]
        lines = [",".join(names), *(",".join(repr(float(v)) for v in row) for row in rows)]
        self.files[f"{name}.csv"] = "\n".join(lines) + "\n"
        return {"file": f"{name}.csv", "columns": names, "units": units}

    def module(self, name: str, texts: Mapping[str, str] | None) -> None:
        """Keep the texts of a module beside the scenario file and its own; note that of another."""
        for each, text in (texts or {}).items():
            if self.files.setdefault(f"{each}.py", text) != text:
                raise ValueError(
                    f"parts of two modules called {each} cannot be written to one folder: "
                    "give one of them another name"
                )
        if not texts and name in sys.modules and name.partition(".")[0] != "simpter_hybrid":
            try:
                self.imported[name] = inspect.getsource(sys.modules[name])
            except (OSError, TypeError):  # of machine code there is none
                self.imported[name] = ""

    def path(self, noted: Any) -> dict[str, Any]:
        path = dataclasses.asdict(noted) if isinstance(noted, Line | Circle) else noted
        x, y = (format_quantity(path[k], "m") for k in ("x", "y"))
        if "radius" in path:
            radius = format_quantity(path["radius"], "m")
            return {"kind": "circle", "centre": [x, y], "radius": radius}
        angle = format_quantity(path["angle"], "rad")
        return {"kind": "line", "point": [x, y], "angle": angle}


def _volts(values: Sequence[float]) -> list[str]:
    return [format_quantity(v, "V") for v in values]
