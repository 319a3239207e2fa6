"""Check scenarios without running them; every problem of every file is reported."""

from __future__ import annotations

import argparse

HELP = "check scenarios without running them"


def arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument("scenario", nargs="+", help="names of shipped scenarios, or TOML files")
    parser.add_argument(
        "--set", action="append", default=[], metavar="PATH=VALUE", help="change a value first"
    )
    parser.add_argument("--json", action="store_true", help="data on stdout")


def execute(args: argparse.Namespace) -> int:
    """Load each; raises InvalidInput with the problems of all."""
    from ..problems import InvalidInput, Problem
    from ..scenario_file import load

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
        return 0
    for name, scenario in sound:
        device = scenario.device
        rate = f"sampled every {scenario.period:g} s" if scenario.period else "no controller"
        print(
            f"{name}: sound ({type(device).__name__}, {device.n} coordinates, {device.m} clutches, "
            f"{len(scenario.loads)} loads, {len(scenario.effects)} effects, {rate}, "
            f"at most {scenario.t_end:g} s)"
        )
    return 0
