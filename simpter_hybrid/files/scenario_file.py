"""Scenarios from TOML: shipped ones by name, others by path; every problem of a file at once."""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from difflib import get_close_matches
from pathlib import Path
from typing import Any

from ..problems import InvalidInput, Problem, Problems, show
from ..reading.reader import TableReader
from ..scenario import METHODS, Scenario
from .tomlfile import STDIN, TomlFile, parse_toml, read_toml

#: Folder of the shipped scenarios.
SHIPPED = Path(__file__).parents[1] / "scenarios"
#: Units that reports may be in (``plots.DISPLAYS``).
UNITS = ("SI", "thesis")


def shipped_scenarios() -> dict[str, Path]:
    """Names and files of the shipped scenarios."""
    files = sorted(SHIPPED.glob("*.toml"), key=lambda file: file.stem)
    return {file.stem: file for file in files}


def find_scenario(name: str | os.PathLike) -> Path:
    """File of a shipped scenario or of a path.

    Parameters
    ----------
    name : str or path
        As for ``load``; a path need not exist if it ends in ``.toml`` or has a folder.

    Raises
    ------
    InvalidInput
        If there is neither.
    """
    text = os.fspath(name)
    known = shipped_scenarios()
    if text in known:
        return known[text]
    if text == STDIN or os.path.exists(text) or text.endswith(".toml") or os.sep in text:
        return Path(text)
    near = get_close_matches(text, known, 1)
    hint = f"did you mean {near[0]}? " if near else ""
    right = f"{hint}one of {', '.join(known)}, or the path of a .toml file"
    raise InvalidInput([Problem(show(text).strip('"'), "", "no such scenario", show(text), right)])


def load(name: str | os.PathLike, overrides: Sequence[str] = ()) -> Scenario:
    """Read a scenario.

    Parameters
    ----------
    name : str or path
        Name of a shipped scenario, or path of a TOML file; ``-`` is standard input.
    overrides : sequence of str
        ``path=value``, e.g. ``"controller.rate=30 Hz"``.

    Raises
    ------
    InvalidInput
        With everything that is wrong: file:line, what, the value, what would be right.
    """
    return with_places(name, overrides)[0]


def with_places(
    name: str | os.PathLike, overrides: Sequence[str] = ()
) -> tuple[Scenario, Problems]:
    """As ``load``, and what knows where in the file everything stands."""
    path = find_scenario(name)
    stem, file = "stdin" if str(path) == STDIN else path.stem, read_toml(path, overrides)
    return scenario_of(file, stem, path.parent), file.problems


def parse(text: str, source: str = "scenario.toml", folder: Path | None = None) -> Scenario:
    """As ``load``, from text; files it names are looked for in ``folder``.

    Parameters
    ----------
    text : str
        TOML.
    source : str
        File name for messages; without its ending the scenario's name, if the text gives none.
    folder : Path, optional
        Default: the working directory.

    Raises
    ------
    InvalidInput
        With everything that is wrong.
    """
    where = folder if folder is not None else Path(".")
    return scenario_of(parse_toml(text, source), Path(source).stem, where)


def scenario_of(file: TomlFile, stem: str, folder: Path) -> Scenario:
    """The scenario a TOML document describes.

    Parameters
    ----------
    file : TomlFile
    stem : str
        The scenario's name, if the file gives none.
    folder : Path
        Where files that it names are looked for.

    Raises
    ------
    InvalidInput
        With everything that is wrong.
    """
    from ..checks.validation import check_scenario

    problems = file.problems
    root = TableReader(file.data, problems)
    values = read_sections(root, stem, folder)
    root.done()
    if len(problems) == 0:
        scenario = Scenario(**values)
        check_scenario(scenario, problems)
        if named := scenario.notes.get("inferred"):
            from .provenance import inferred_values
            from .scenario_text import document

            found = inferred_values(named, document(scenario), problems)
            scenario = scenario.replace(notes={**scenario.notes, "inferred": found})
    problems.raise_if_any()
    return scenario


def read_sections(root: TableReader, stem: str, folder: Path) -> dict[str, Any]:
    """What ``Scenario`` takes; placeholders where something is wrong.

    Parameters
    ----------
    root : TableReader
        Of the whole document; its problems are collected there.
    stem, folder
        As for `scenario_of`.
    """
    from ..reading import sections
    from ..reading.clutches import read_clutches
    from ..reading.ends import read_stops
    from ..reading.fields import Context
    from ..reading.sensors import read_readings

    notes: dict[str, Any] = {}
    for key in ("about", "answers_to"):
        if text := root.text(key, ""):
            notes[key] = text
    if "inferred" in root:
        notes["inferred"] = root.texts("inferred")
    if "units" in root:
        notes["units"] = root.choice("units", UNITS)
    name = root.text("name", stem)
    if not re.fullmatch(r"[A-Za-z0-9_][A-Za-z0-9_.+-]{0,99}", name) and name:
        right = "letters a to z, digits and _ . + - (it names a directory), at most 100"
        root.problem("name", "not a name", right)
    device, its_notes = sections.read_device(root.table("device"), folder)
    context = Context(folder, device)
    path = sections.read_path(root)
    values = {
        "name": name,
        "device": device,
        "clutches": read_clutches(root, device, folder),
        "loads": sections.read_loads(root, context),
        "effects": sections.read_effects(root, context),
        "stops": read_stops(root, context),
        **sections.read_start(root, device),
        **_read_run(root.table("run")),
    }
    if tolerances := sections.read_tolerances(root):
        notes["tolerances"] = tolerances
    if readings := read_readings(root, device):
        notes["readings"] = readings
    stages, period = sections.read_controller(root, device, folder, path)
    notes |= its_notes | ({"path": path} if path else {})
    return values | {"controllers": stages, "period": period, "notes": notes}


def _read_run(table: TableReader) -> dict[str, Any]:
    """``[run]``."""
    return {
        "t_end": table.quantity("time", "t_end", above="0 s", max="1e6 s"),
        "method": table.choice("method", METHODS, "DOP853"),
        "rtol": table.number("rtol", 1e-10, min=1e-13, max=1e-2),
        "atol": table.number("atol", 1e-12, above=0.0, max=1e-2),
        "max_step": table.quantity("time", "max_step", "20 ms", above="0 s"),
        "event_limit": table.integer("event_limit", 100_000, min=1),
    }
