"""Print a scenario: as it was written, or with every default filled in."""

from __future__ import annotations

import argparse
import sys

from . import DONE

HELP = "print a scenario, with --resolved all its defaults"


def arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument("scenario", help="name of a shipped scenario, or a TOML file, or - (stdin)")
    parser.add_argument(
        "--set", action="append", default=[], metavar="PATH=VALUE", help="change a value first"
    )
    parser.add_argument("--resolved", action="store_true", help="every default filled in, SI units")
    parser.add_argument("--json", action="store_true", help="the resolved scenario as JSON")


def execute(args: argparse.Namespace) -> int:
    """Print the scenario."""
    from ..files.scenario_file import find_scenario, load

    if not (args.resolved or args.json or args.set):
        from ..files.tomlfile import parse_toml, read_text

        text, source = read_text(find_scenario(args.scenario))
        parse_toml(text, source)  # a file that is no TOML is a problem here as well
        sys.stdout.write(text.replace("\r\n", "\n"))
        return DONE
    from ..files.scenario_text import resolve

    text = resolve(load(args.scenario, args.set)).text
    if args.json:
        import json
        from tomllib import loads

        text = json.dumps(loads(text), indent=2) + "\n"
    sys.stdout.write(text)
    return DONE
