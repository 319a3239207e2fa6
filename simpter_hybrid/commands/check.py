"""Check scenarios and maps without running them; every problem of every file is reported.

Of a recording a map is printed that is to be filled in.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from typing import TYPE_CHECKING

from . import DONE

if TYPE_CHECKING:
    from ..scenario import Scenario

HELP = "check scenarios and maps, each by itself; of a recording, print a map to fill in"

#: Endings of recordings, without a further ``.gz``, and of what has to be saved as one first.
DATA = (
    ".csv", ".tsv", ".txt", ".dat", ".npz", ".npy", ".mat", ".tdms", ".xlsx", ".xls", ".ods",
    ".parquet", ".h5", ".hdf5",
)  # fmt: skip


def arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument(
        "scenario",
        nargs="+",
        help="shipped scenarios, TOML files (maps too), - (a scenario on stdin), or recordings",
    )
    parser.add_argument(
        "--set", action="append", default=[], metavar="PATH=VALUE", help="change a value first"
    )
    parser.add_argument("--json", action="store_true", help="data on stdout")


def execute(args: argparse.Namespace) -> int:
    """Load every scenario or map named and print what each holds.

    Raises
    ------
    InvalidInput
        With the problems of all files, if any has one.
    """
    from ..problems import InvalidInput, Problem

    problems: list[Problem] = []
    sound = []
    maps: dict[str, str] = {}
    for name in args.scenario:
        try:
            if _is_recording(name):
                maps[name] = _draft(name, args.set)
                sound.append(maps[name])
                continue
            read = _map if _is_map(name) else _scenario
            sound.append(f"{name}: sound ({read(name, args.set)})")
        except InvalidInput as error:
            problems += error.problems
    if problems:
        raise InvalidInput(problems)
    if args.json:
        import json

        print(json.dumps({"problems": []} | ({"maps": maps} if maps else {}), indent=2))
        return DONE
    for told in sound:
        print(told)
    return DONE


def _is_recording(name: str) -> bool:
    """Whether a name is that of a file of data."""
    return name.lower().removesuffix(".gz").endswith(DATA)


def _draft(name: str, changes: Sequence[str]) -> str:
    from ..identification.recordings.draft_map import draft_map

    _refuse(changes, name, "a recording")
    return draft_map(name).rstrip("\n")


def _is_map(name: str) -> bool:
    """Whether a file is a map of recordings: it has channels."""
    import tomllib
    from pathlib import Path

    if not Path(name).is_file():  # a pipe waits for whoever writes
        return False
    try:
        tables = tomllib.loads(Path(name).read_text("utf-8")).keys()
        return bool(tables & {"channels", "time", "runs", "split"}) and "device" not in tables
    except (OSError, ValueError, RecursionError):
        return False  # a scenario's own reader says what is wrong


def _map(name: str, changes: Sequence[str]) -> str:
    from ..identification.recordings.map_file import read_map

    _refuse(changes, name, "a map")
    channels = read_map(name).channels.values()
    return "map of " + ", ".join(f"{c.signal} ({c.role}, {c.unit})" for c in channels)


def _refuse(changes: Sequence[str], name: str, what: str) -> None:
    from ..problems import InvalidInput, Problem

    if changes:
        raise InvalidInput([Problem(name, "--set", what, changes[0], "a scenario to change")])


def _scenario(name: str, changes: Sequence[str]) -> str:
    from ..files.scenario_file import with_places
    from ..identification.fits import check_tolerances

    scenario, places = with_places(name, changes)
    if scenario.notes.get("tolerances"):
        check_tolerances(scenario, places)
    device = scenario.device
    rate = f"sampled every {scenario.period:g} s" if scenario.period else "no controller"
    return (
        f"{type(device).__name__}, {_count(device.n, 'coordinate')}, "
        f"{_count(device.m, 'clutch', 'clutches')}, {_count(len(scenario.loads), 'load')}, "
        f"{_count(len(scenario.effects), 'effect')}, {rate}, at most {scenario.t_end:g} s"
        f"{_never_on(scenario)}"
    )


def _never_on(scenario: Scenario) -> str:
    """Words on clutches of a model to be diagnosed that only a recorded command would switch on.

    One for friction that is always there was declared without a threshold below 0 V.
    """
    if not scenario.notes.get("tolerances") or scenario.controllers:
        return ""
    told = scenario.command or (0.0,) * scenario.device.m
    clutches = enumerate(zip(scenario.clutches, told, strict=True), 1)
    off = [f"clutch.{k}.threshold" for k, (c, level) in clutches if level <= c.threshold]
    if not off:
        return ""
    return (
        f"; nothing commands friction beyond {' and '.join(off)}: it is off in a recording without "
        'a command, where "-1 V" is for friction that is always there'
    )


def _count(number: int, one: str, many: str = "") -> str:
    return f"{number} {one if number == 1 else many or one + 's'}"
