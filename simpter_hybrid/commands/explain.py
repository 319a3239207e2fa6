"""Explain a run at an instant: why did it slip, or stick, there?"""

from __future__ import annotations

import argparse
import sys
from typing import Any

from . import DONE

HELP = "why did a run slip, or stick, at an instant?"


def arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument("run", help="directory of a run, or name or file of a scenario to run")
    parser.add_argument("--at", required=True, metavar="T", help='instant, e.g. 0.9 or "900 ms"')
    parser.add_argument("--json", action="store_true", help="data on stdout")


def execute(args: argparse.Namespace) -> int:
    """Load the run, explain the event nearest to the instant.

    Raises
    ------
    InvalidInput
        If the instant or the run cannot be read, or the instant is not within the run.
    """
    from ..problems import InvalidInput, Problem, Problems

    problems = Problems("simpter explain")
    t = _instant(args.at, problems)
    problems.raise_if_any()
    trajectory = _trajectory(args.run)
    from ..explanation.explain import explain

    try:
        found = explain(trajectory, t)
    except ValueError as error:
        right = f"an instant from 0 s to {trajectory.t_end:.6g} s"
        raise InvalidInput([Problem("--at", "", str(error), args.at, right)]) from None
    if args.json:
        import dataclasses

        from ..files.json_text import json_text

        sys.stdout.write(json_text({**dataclasses.asdict(found), "note": found.note}))
    else:
        print(found)
    return DONE


def _instant(text: str, problems: Any) -> float:
    from ..units import QuantityError, expected_quantity, parse_quantity

    try:
        return parse_quantity(float(text), "dimensionless")
    except ValueError:
        pass
    try:
        return parse_quantity(text, "time")
    except QuantityError as error:
        problems.add((), error.what, text, expected_quantity("time"), "--at")
        return 0.0


def _trajectory(name: str) -> Any:
    import os

    from ..problems import InvalidInput, Problem

    if os.path.isdir(name):
        from ..files.storage import StoredRunError, load

        try:
            return load(name)
        except StoredRunError as error:
            right = "the directory of a run, as simpter run writes it"
            raise InvalidInput([Problem(name, "", str(error), name, right)]) from None
    from ..api import run
    from ..files.scenario_file import find_scenario

    try:
        file = find_scenario(name)
    except InvalidInput as error:  # it knows of scenarios alone
        also = "or a directory that simpter run wrote"
        raise InvalidInput(p._replace(right=f"{p.right}, {also}") for p in error.problems) from None
    if os.sep in name and not file.exists():
        right = "a directory that simpter run wrote, or a scenario file"
        raise InvalidInput([Problem(name, "", "no such file or directory", "nothing", right)])
    return run(name)
