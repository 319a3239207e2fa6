"""What the thesis leaves for later, tried: tables, sentences and pictures, a page a study.

Without a name every study is run. Studies need the compiled engine.
"""

from __future__ import annotations

import argparse

from . import DONE
from .out_directory import check_out

HELP = "the thesis's future work, study by study"


def arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument("name", nargs="*", help="studies, e.g. measurements")
    parser.add_argument("--list", action="store_true", help="the names of all studies")
    parser.add_argument("--size", type=int, help="seeds or sets of plausible inputs (24)")
    parser.add_argument("--out", metavar="DIR", help="write pages there (all: out/studies)")
    parser.add_argument("--json", action="store_true", help="the numbers as data on stdout")


def execute(args: argparse.Namespace) -> int:
    """Run the studies.

    Raises
    ------
    InvalidInput
        If a study is unknown, or `--size` is below the least.
    """
    import sys

    from ..problems import InvalidInput, Problem
    from ..studies.registry import FEWEST, STUDIES, study

    if args.list:
        for name, (_, about) in STUDIES.items():
            print(f"{name:16} {about}")
        return DONE
    names = list(dict.fromkeys(args.name)) or list(STUDIES)
    here = "simpter study"
    problems = [
        Problem(here, "", "unknown study", name, f"one of {', '.join(STUDIES)}")
        for name in names
        if name not in STUDIES
    ]
    if args.size is not None and args.size < FEWEST:
        least = f"at least {FEWEST}, for a share or a scatter"
        problems.append(Problem(here, "--size", "too few runs", str(args.size), least))
    if problems:
        raise InvalidInput(problems)
    folder = args.out or ("" if args.name else "out/studies")
    if folder:
        check_out(folder, "numbers.json", names)
    from ..files.json_text import json_text
    from ..studies.page import as_text, write_pages

    done = {}
    for name in names:
        print(f"{name} ...", file=sys.stderr, flush=True)
        done[name] = study(name, args.size)
        if not args.json:
            print(as_text(name, done[name]), flush=True)
    if args.json:
        print(json_text({n: s.numbers for n, s in done.items()}), end="")
    if folder:
        page = write_pages(done, folder, args.size)
        print(f"page: {page}", file=sys.stderr)
    return DONE
