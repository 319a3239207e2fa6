"""``[clutch]`` and ``[[clutches]]`` of a scenario file."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from ..clutch import Clutch
from ..device import Device
from ..problems import KeyPath, Problems
from .fields import Context, build, read_part
from .reader import TableReader


def read_clutches(root: TableReader, device: Device | None, folder: Path) -> tuple[Clutch, ...]:
    """``[clutch]`` for all; ``[[clutches]]``, one each, say what differs, or all without it.

    Parameters
    ----------
    root : TableReader
        Of the whole document.
    device : Device or None
        None where it could not be read.
    folder : Path
        Where files that the tables name are looked for.
    """
    context = Context(folder, device)
    m = device.m if device is not None else 0
    if "clutches" in root:
        tables = root.tables("clutches")
        if device is not None and len(tables) != m:
            names = ", ".join(device.surfaces)
            root.problem("clutches", "wrong number of clutches", f"{m}, for {names}")
        if "clutch" in root:
            common = root.raw("clutch")
            if not isinstance(common, Mapping):
                root.problem("clutch", "not a table", "a table, [clutch], of what all have")
                return ()
            for table in tables:
                _complete(table, common)
        return tuple(_read_clutch(table, context) for table in tables)
    if device is not None and m == 0 and "clutch" not in root:
        return ()
    return (_read_clutch(root.table("clutch"), context),) * m


def _read_clutch(table: TableReader, context: Context) -> Clutch:
    torque = read_part(table.table("torque"), "torque", context)
    clutch = build(table, Clutch, context, torque=torque)
    return clutch if clutch is not None and torque is not None else Clutch()  # type: ignore[return-value]


def _complete(table: TableReader, common: Mapping[str, Any]) -> None:
    """Give one clutch's table what it leaves to ``[clutch]``; problems are shown where that stands.

    A torque law of another kind takes the place of the common one; without a kind it is the common
    law with some numbers changed.
    """
    own = dict(table.data)
    for key in common.keys() - own.keys():
        _placed(table.problems, ("clutch", key), (*table.path, key))
    law, mine = common.get("torque"), own.get("torque")
    if isinstance(law, Mapping) and isinstance(mine, Mapping) and "kind" not in mine:
        for key in law.keys() - mine.keys():
            _placed(table.problems, ("clutch", "torque", key), (*table.path, "torque", key))
        own["torque"] = {**law, **mine}
    table.data = {**common, **own}


def _placed(problems: Problems, source: KeyPath, target: KeyPath) -> None:
    """What a clutch's table takes over stands at the common table's lines."""
    n = len(source)
    for path, place in list(problems.places.items()):
        if path[:n] == source:
            problems.places[(*target, *path[n:])] = place
