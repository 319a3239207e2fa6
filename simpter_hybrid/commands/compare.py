"""Run a scenario exactly and with Karnopp's band, and measure what the band does to it."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import Any

from . import CHECK_FAILED, DONE, FAILED

#: What a directory with a comparison is known by.
MARK = "comparison.json"
HELP = "compare Karnopp's band, or smooth friction, with the exact run"


def arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument("scenario", help="name of a shipped scenario, or a TOML file")
    parser.add_argument(
        "--set", action="append", default=[], metavar="PATH=VALUE", help="change a value first"
    )
    parser.add_argument(
        "--band",
        default="1e-2,1e-3,1e-4",
        metavar="B,...",
        help="bands of Karnopp's model [rad/s] (%(default)s)",
    )
    parser.add_argument(
        "--rules",
        default="thesis,tuned",
        metavar="R,...",
        help="rules of Karnopp's model: thesis (as printed there), fair (its tables, every choice "
        "it leaves open made for the better), tuned (without the tables) (%(default)s)",
    )
    parser.add_argument("--step", type=float, help="a fixed step [s] instead of a variable one")
    parser.add_argument(
        "--width", default="", metavar="W,...", help="widths of friction made smooth [rad/s]"
    )
    parser.add_argument(
        "--bound",
        action="append",
        default=[],
        metavar="NAME=VALUE",
        help="exit code 1 when it is exceeded, e.g. --bound final_error=1e-3 (SI)",
    )
    parser.add_argument("--out", metavar="DIR", help="pictures and comparison.json go here")
    parser.add_argument("--force", action="store_true", help="replace an earlier comparison there")
    parser.add_argument("--json", action="store_true", help="data on stdout")
    parser.add_argument("--quiet", action="store_true", help="no progress on stderr")


def execute(args: argparse.Namespace) -> int:
    """Check the arguments, run everything, print, draw, judge."""
    from ..problems import Problems

    problems = Problems("simpter compare")
    bands = numbers(args.band, "--band", problems)
    widths = numbers(args.width, "--width", problems)
    rules = words(args.rules, problems)
    bounds = bounds_of(args.bound, problems)
    if args.step is not None and not 0.0 < args.step < float("inf"):
        problems.add((), "not a step", args.step, "a positive number of seconds", "--step")
    if not widths and not (bands and rules):
        right = "at least one of --band (with --rules) or --width"
        problems.add((), "nothing to compare with", args.band, right, "--band")
    check_directory(args.out, args.force, problems)
    problems.raise_if_any()
    from ..files.scenario_file import load

    scenario = load(args.scenario, args.set)
    from ..comparison import compare, karnopp, regularised

    solver = "variable" if args.step is None else "fixed"
    candidates = [karnopp(b, r, solver, args.step) for r in rules for b in bands]
    candidates += [regularised(w) for w in widths]

    def progress(name: str) -> None:
        if not args.quiet:
            print(name, file=sys.stderr)

    try:
        found = compare(scenario, candidates, progress=progress)
    except RuntimeError as error:
        print(error, file=sys.stderr)
        return FAILED
    return report(found, bounds, args)


def report(found: Any, bounds: dict[str, float], args: argparse.Namespace) -> int:
    """Data and table to stdout, times to stderr, files to ``--out``; returns the exit code."""
    from ..comparison.bounds import exceeded
    from ..comparison.table import text_of
    from ..files.json_text import json_text

    text = json_text(found.as_dict())
    unsaid = None
    try:
        sys.stdout.write(text if args.json else text_of(found))
        sys.stdout.flush()
    except (
        OSError
    ) as error:  # nobody reads it, or a disk is full: the files are written all the same
        unsaid = error
    if not args.quiet:
        print(f"exact: {found.reference_cpu:.3f} s of processor time", file=sys.stderr)
        for row in found.rows:
            print(f"{row.name}: {row.cpu:.3f} s", file=sys.stderr)
    if args.out:
        from ..files.replaced_files import replace_files
        from ..plots.comparison import FIGURES, comparison_figures
        from ..plots.style import png

        files = {f"{name}.png": png(picture) for name, picture in comparison_figures(found).items()}
        earlier = [f"{name}.png" for name in FIGURES]
        replace_files(Path(args.out), {**files, MARK: text.encode()}, earlier)
    broken = exceeded(found, bounds)
    for line in broken:
        print(f"check failed: {line}", file=sys.stderr)
    if unsaid is not None and not broken:
        raise unsaid
    if broken:
        return CHECK_FAILED
    return FAILED if any(row.status == "failed" for row in found.rows) else DONE


def check_directory(out: str | None, force: bool, problems: Any) -> None:
    """Refuse, before anything is computed, a directory that must or could not be written."""
    from ..files.replaced_files import PARTIAL
    from ..files.run_directory import RunDirectoryError, check_makeable

    if out is None:
        return
    try:
        if not out:
            raise RunDirectoryError("an empty name")
        check_makeable(Path(out) / MARK)
        ours = (Path(out) / MARK).is_file()
        there = Path(out).iterdir() if Path(out).is_dir() else ()
        taken = any(not file.name.startswith(PARTIAL) for file in there)
        if taken and not (force and ours):
            problems.add(
                (), "not free", out, "a new directory, or --force to replace a comparison", "--out"
            )
    except OSError as error:
        problems.add((), str(error), out, "a directory that can be written", "--out")


def numbers(text: str, option: str, problems: Any) -> list[float]:
    """Positive numbers separated by commas."""
    found = []
    for word in filter(None, text.split(",")):
        try:
            value = float(word)
        except ValueError:
            value = float("nan")
        if not 0.0 < value < float("inf"):
            problems.add((), "not a slip speed", word, "a positive number of rad/s", option)
        found.append(value)
    return found


def words(text: str, problems: Any) -> list[str]:
    """Names of rules separated by commas."""
    known = ("thesis", "fair", "tuned")
    found = list(filter(None, text.split(",")))
    for word in found:
        if word not in known:
            problems.add((), "no such rules", word, f"one of {', '.join(known)}", "--rules")
    return found


def bounds_of(given: list[str], problems: Any) -> dict[str, float]:
    """Bounds by name."""
    from ..comparison.bounds import BOUNDED

    found = {}
    for entry in given:
        name, _, text = entry.partition("=")
        try:
            value = float(text)
        except ValueError:
            value = float("nan")
        if name not in BOUNDED:
            right = f"one of {', '.join(BOUNDED)}, as in final_error=1e-3"
            problems.add((), "nothing that can be bounded", entry, right, "--bound")
        elif not 0.0 <= value < float("inf"):
            problems.add((), "not a bound", entry, f"{name}=VALUE, VALUE 0 or more", "--bound")
        elif name in found:
            problems.add((), "a second bound of it", entry, f"one {name}", "--bound")
        found[name] = value
    return found
