"""List the scenarios that come with the program."""

from __future__ import annotations

import argparse
from typing import Any

HELP = "list the scenarios that come with the program"


def arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument("--json", action="store_true", help="data on stdout")


def execute(args: argparse.Namespace) -> int:
    """Print names and what they are about."""
    from ..scenario_file import shipped_scenarios

    found = [_entry(name, file) for name, file in shipped_scenarios().items()]
    if args.json:
        import json

        print(json.dumps(found, indent=2))
        return 0
    width = max(len(entry["name"]) for entry in found)
    for entry in found:
        print(f"{entry['name']:<{width}}  {entry['about']} [{entry['answers_to']}]")
    return 0


def _entry(name: str, file: Any) -> dict[str, str]:
    from tomllib import loads

    data = loads(file.read_text(encoding="utf-8"))
    return {
        "name": name,
        "about": data.get("about", ""),
        "answers_to": data.get("answers_to", ""),
        "file": str(file),
    }
