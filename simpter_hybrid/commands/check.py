"""Check scenarios without running them; every problem of every file is reported."""

from __future__ import annotations

import argparse

from . import DONE

HELP = "check scenarios without running them"


def arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument(
        "scenario", nargs="+", help="names of shipped scenarios, or TOML files, or - (stdin)"
    )
    parser.add_argument(
        "--set", action="append", default=[], metavar="PATH=VALUE", help="change a value first"
    )
    parser.add_argument("--json", action="store_true", help="data on stdout")


def execute(args: argparse.Namespace) -> int:
    """Load every scenario named and print what each holds.

    Raises
    ------
    InvalidInput
        With the problems of all files, if any has one.
    """
    from ..files.scenario_file import load
    from ..problems import InvalidInput, Problem

    problems: list[Problem] = []
    sound = []
    for name in args.scenario:
        try:
            sound.append((name, load(name, args.set)))
        except InvalidInput as error:
            problems += error.problems
    if problems:
        raise InvalidInput(problems)
    if args.json:
        import json

        print(json.dumps({"problems": []}, indent=2))
        return DONE
    for name, scenario in sound:
        device = scenario.device
        rate = f"sampled every {scenario.period:g} s" if scenario.period else "no controller"
        print(
            f"{name}: sound ({type(device).__name__}, {_count(device.n, 'coordinate')}, "
            f"{_count(device.m, 'clutch', 'clutches')}, {_count(len(scenario.loads), 'load')}, "
            f"{_count(len(scenario.effects), 'effect')}, {rate}, at most {scenario.t_end:g} s)"
        )
    return DONE


def _count(number: int, one: str, many: str = "") -> str:
    return f"{number} {one if number == 1 else many or one + 's'}"
