"""Run a scenario; write its resolved form, trajectory, events, summary, pictures and report."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..engines import ENGINES
from . import CHECK_FAILED, DONE, FAILED, INTERRUPTED

if TYPE_CHECKING:
    from ..trajectory import Trajectory

HELP = "run a scenario and write its files"

#: A balance worse than this, relative to the energy turned over, is a failed check.
BALANCE = 1e-6
#: So is a clutch that delivers more than this part of the mean power turned over (rounding: 1e-16).
DELIVERED = 1e-9


def arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument("scenario", help="name of a shipped scenario, or a TOML file, or - (stdin)")
    parser.add_argument(
        "--set",
        action="append",
        default=[],
        metavar="PATH=VALUE",
        help='change a value, e.g. --set controller.rate="30 Hz" or --set loads.0.along="5 lbf"',
    )
    parser.add_argument("--out", metavar="DIR", help="where the files go (out/NAME)")
    parser.add_argument("--force", action="store_true", help="replace the files of an earlier run")
    parser.add_argument(
        "--engine",
        choices=ENGINES,
        default="reference",
        help="reference (SciPy) or compiled (LLVM)",
    )
    parser.add_argument("--no-report", action="store_true", help="no pictures and no report.html")
    parser.add_argument("--units", choices=("SI", "thesis"), help="units of pictures and report")
    parser.add_argument("--json", action="store_true", help="the summary as data on stdout")
    parser.add_argument("--quiet", action="store_true", help="no progress on stderr")


def execute(args: argparse.Namespace) -> int:
    """Check everything that can be checked, run, write, say how it went."""
    import signal

    from ..files.scenario_file import load

    signal.signal(signal.SIGTERM, signal.default_int_handler)  # ends the drawing as Ctrl-C does
    scenario = load(args.scenario, args.set)
    directory = Path(args.out if args.out is not None else f"out/{scenario.name}")
    check_directory(directory, args)
    check_writable(scenario)

    from ..api import run
    from ..progress import Progress

    with Progress(scenario.t_end, args.quiet) as progress:
        trajectory = run(scenario, engine=args.engine, progress=progress)
    interrupted = trajectory.status == "interrupted" or progress.interrupted
    interrupted |= write(trajectory, directory, args, not (args.no_report or interrupted))
    failed = say(trajectory, directory, args)
    if interrupted:
        return INTERRUPTED
    return FAILED if trajectory.status == "failed" else CHECK_FAILED if failed else DONE


def check_directory(directory: Path, args: argparse.Namespace) -> None:
    """Refuse, before anything is computed, a directory that could not be written afterwards.

    Raises
    ------
    InvalidInput
        If the directory is not free, or cannot be made.
    """
    from ..files.run_directory import RunDirectoryError, check_free, check_makeable
    from ..problems import InvalidInput, Problem

    where = "--out" if args.out is not None else "simpter run"
    right = "the name of a new directory (--out), or --force to replace an earlier run"
    try:
        if not args.out and args.out is not None:
            raise RunDirectoryError("an empty name")
        check_free(directory, args.force)
        check_makeable(directory)
    except (OSError, ValueError) as error:  # ValueError: a null character in the name
        what = str(error)
        raise InvalidInput([Problem(where, "", what, str(directory), right)]) from None


def check_writable(scenario: Any) -> None:
    """Refuse a scenario that could not be written out again.

    Raises
    ------
    InvalidInput
        If a part of the scenario cannot be imported by name.
    """
    from ..files.scenario_text import resolve
    from ..problems import InvalidInput, Problem

    try:
        resolve(scenario)
    except ValueError as error:
        right = "parts that can be imported by name"
        raise InvalidInput([Problem(scenario.name, "", str(error), "it", right)]) from None


def write(trajectory: Trajectory, directory: Path, args: argparse.Namespace, report: bool) -> bool:
    """The files of the run; returns whether Ctrl-C was pressed meanwhile, and minded."""
    from ..api import save
    from ..progress import Progress

    def also(partial: Path) -> None:
        from ..plots import DISPLAYS, figures, png
        from ..report.page import write_report

        display = DISPLAYS[args.units or trajectory.scenario.notes.get("units", "SI")]
        text = (partial / "scenario.toml").read_text(encoding="utf-8")
        drawn = figures(trajectory, display=display)
        pictures = {name: png(picture) for name, picture in drawn.items()}
        write_report(trajectory, partial / "report.html", text, display, pictures=pictures)
        for name, picture in pictures.items():
            (partial / f"{name}.png").write_bytes(picture)

    report = report and len(trajectory.segment_t) > 0 and trajectory.t_end > 0.0
    if report and not args.quiet:
        print("drawing the report", file=sys.stderr)
    try:
        if report:
            save(trajectory, directory, args.force, also)
            return False
    except BaseException:  # what took long was the run: it outlives whatever ended the drawing
        with Progress(trajectory.scenario.t_end, quiet=True):
            save(trajectory, directory, args.force)
        print(f"the report was not finished; the run is in {directory}", file=sys.stderr)
        raise
    with Progress(trajectory.scenario.t_end, quiet=True) as minded:
        save(trajectory, directory, args.force)
    return minded.interrupted


def say(trajectory: Trajectory, directory: Path, args: argparse.Namespace) -> bool:
    """Print how the run went; returns whether a check failed."""
    import json

    text = (directory / "summary.json").read_text(encoding="utf-8")
    found = json.loads(text)
    energy = found["energy"]
    bad = []
    if energy is not None and trajectory.status in ("finished", "stopped"):
        if None in (energy["turnover"], energy["max_clutch_power"]):
            bad.append("energies too large for a number; are masses and speeds in these units?")
            energy = None
        elif energy["relative"] is not None and not energy["relative"] <= BALANCE:
            bad.append(f"the energy balance misses {energy['relative']:.2g} of the turnover")
        mean = energy["turnover"] / found["run_time_s"] if energy else 0.0
        if energy and energy["max_clutch_power"] > DELIVERED * mean:
            bad.append(f"a clutch delivers {energy['max_clutch_power']:.2g} W")
    for line in bad:
        print(f"check failed: {line}", file=sys.stderr)
    if args.json:
        sys.stdout.write(text)
    else:
        counts = f"{len(trajectory.events)} events, {trajectory.statistics['steps']} steps"
        print(f"{trajectory.status}: {trajectory.message} ({counts})")
        balance = energy and energy["relative"]
        if balance is not None:
            print(f"energy balance closes to {balance:.1e} of the turnover")
        print(f"files in {directory}")
    return bool(bad)
