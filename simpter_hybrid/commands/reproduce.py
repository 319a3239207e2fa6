"""Compare with the thesis: printed value, what comes out here, verdict.

Without a name every comparison is run, and a page with pictures is written.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Mapping
from typing import TYPE_CHECKING

from ..engines import ENGINES
from . import DONE
from .out_directory import check_out

if TYPE_CHECKING:
    from ..reproduce.rows import Engine, Row

HELP = "compare with the thesis, figure by figure"


def arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument("name", nargs="*", help="comparisons, figures or tables, e.g. figure-50")
    parser.add_argument("--list", action="store_true", help="the names of all comparisons")
    parser.add_argument("--draws", type=int, help="sets of plausible inputs (each has a default)")
    parser.add_argument(
        "--engine", choices=ENGINES, default="reference",
        help="reference (SciPy, default) or compiled (LLVM)",
    )  # fmt: skip
    parser.add_argument("--out", metavar="DIR", help="write a page there (all: out/reproduce)")
    parser.add_argument("--json", action="store_true", help="rows as data on stdout")


def execute(args: argparse.Namespace) -> int:
    """Run the comparisons; 0 whatever the verdicts: a claim that fails is a finding.

    Raises
    ------
    InvalidInput
        If a name is unknown, or `--draws` is too small for a share.
    """
    from ..reproduce.registry import REPRODUCTIONS, reproduce

    if args.list:
        for name, (_, about) in REPRODUCTIONS.items():
            print(f"{name:16} {about}")
        return DONE
    names = _asked(args) or list(REPRODUCTIONS)
    folder = args.out or ("" if args.name else "out/reproduce")
    if folder:
        check_out(folder, "rows.json", names)
    if args.engine == "compiled":
        from ..compiled import simulate as engine
    else:
        from ..engine import simulate as engine
    comparisons = {}
    for name in names:
        print(f"{name} ...", file=sys.stderr, flush=True)
        comparisons[name] = reproduce(name, engine, args.draws)
        if not args.json:
            from ..reproduce.page import as_text

            print(as_text(name, comparisons[name]), flush=True)
    if args.json:
        from ..reproduce.rows import plain

        data = {name: [row.as_dict() for row in rows] for name, rows in comparisons.items()}
        print(json.dumps(data, indent=1, default=plain))
    if folder:
        _write(comparisons, folder, engine, args.draws)
    return DONE


def _asked(args: argparse.Namespace) -> list[str]:
    """Names of the comparisons asked for, each once."""
    from ..problems import InvalidInput, Problem
    from ..reproduce.registry import resolve

    names, problems = [], []
    for name in args.name:
        try:
            names.append(resolve(name))
        except ValueError:  # it lists every name, as --list does
            what, right = "no such comparison, figure or table", "one of the names of --list"
            problems.append(Problem("simpter reproduce", "", what, name, right))
    if args.draws is not None and args.draws < 2:
        what, right = "too few sets of inputs", "at least 2, for a share"
        problems.append(Problem("--draws", "", what, str(args.draws), right))
    if problems:
        raise InvalidInput(problems)
    return list(dict.fromkeys(names))


def _write(
    comparisons: Mapping[str, list[Row]], folder: str, engine: Engine, draws: int | None
) -> None:
    """The page, and that of what only the exact model shows if it was asked for."""
    from ..reproduce.page import write_page
    from ..reproduce.pictures import pictures

    page = write_page(comparisons, folder, pictures(list(comparisons), engine))
    print(f"page: {page}", file=sys.stderr)
    if "found-by-exact" in comparisons:
        from ..reproduce.found_page import write_found

        print(f"page: {write_found(engine, page.parent, draws)}", file=sys.stderr)
