"""Run a scenario; write its resolved form, trajectory, events, summary, pictures and report."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..engines import ENGINES
from . import CHECK_FAILED, DONE, FAILED, INTERRUPTED, INVALID

if TYPE_CHECKING:
    from ..progress import Interrupts
    from ..trajectory import Trajectory

HELP = "run a scenario and write its files"

#: A balance worse than this, relative to the energy turned over, is a failed check.
BALANCE = 1e-6
#: So is a clutch that delivers more than this part of the mean power turned over (rounding: 1e-16)
#: beyond the solver's error, which counts where a device mostly stands still.
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
    from ..files.scenario_file import load
    from ..progress import end_as_interrupted

    end_as_interrupted()
    scenario = load(args.scenario, args.set)
    directory = Path(args.out if args.out is not None else f"out/{scenario.name}")
    check_directory(directory, args)
    check_writable(scenario)

    from ..api import run
    from ..progress import Interrupts, Progress

    with Interrupts() as interrupts:
        with Progress(scenario.t_end, args.quiet) as progress:
            trajectory = run(scenario, engine=args.engine, progress=progress)
        interrupted = trajectory.status == "interrupted" or progress.interrupted
        report = not (args.no_report or interrupted)
        written = write(trajectory, directory, args, report, interrupts)
    failed = say(trajectory, written, args)
    if interrupted or interrupts.interrupted:
        return INTERRUPTED
    if written != directory:
        return INVALID
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


def write(
    trajectory: Trajectory,
    directory: Path,
    args: argparse.Namespace,
    report: bool,
    interrupts: Interrupts,
) -> Path:
    """The files of the run; returns the directory that they are in.

    What took long was the run: it outlives whatever ends what is made of it afterwards.
    """
    from ..files.run_directory import free_beside, run_directory
    from ..files.scenario_text import resolve
    from ..files.storage import put_run, put_summary, put_tables

    def otherwise(taken: Path) -> Path:
        nonlocal directory
        directory = free_beside(taken)
        print(
            f"{taken} was taken by another run meanwhile; this one is in {directory}: rename it, "
            "and give every run its own --out",
            file=sys.stderr,
        )
        return directory

    resolved = resolve(trajectory.scenario)
    with run_directory(directory, args.force, otherwise) as partial:
        put_run(trajectory, partial, resolved.text, resolved.files)
        put_summary(trajectory, partial, measured=False)
        steps: dict[str, Callable[[], object]] = {
            "measures in summary.json": lambda: put_summary(trajectory, partial),
            "events.csv": lambda: put_tables(trajectory, partial),
        }
        if report and trajectory.t_end > 0.0:
            steps["report.html"] = lambda: draw(trajectory, partial, resolved.text, args)
        ended, left = take(steps, partial, interrupts)
    without = f", without {', '.join(left)}" if left else ""
    if ended is not None and not isinstance(ended, KeyboardInterrupt):
        print(f"not finished: the run is in {directory}{without}", file=sys.stderr)
        raise ended
    if interrupts.interrupted:
        print(f"interrupted: the run is in {directory}{without}", file=sys.stderr)
    return directory


def take(
    steps: Mapping[str, Callable[[], object]], directory: Path, interrupts: Interrupts
) -> tuple[BaseException | None, list[str]]:
    """Take all steps; returns what ended them early, and the names of those not taken.

    Nothing is left in ``directory`` of the step that was not taken whole.
    """
    left = list(steps)
    before = set(directory.iterdir())
    try:
        with interrupts.heard():
            while left:
                before = set(directory.iterdir())
                steps[left[0]]()
                del left[0]
    except BaseException as error:
        for file in set(directory.iterdir()) - before:
            file.unlink()
        return error, left
    return None, left


def draw(trajectory: Trajectory, directory: Path, text: str, args: argparse.Namespace) -> None:
    """Pictures and report."""
    import numpy as np

    from ..plots import DISPLAYS, figures, png
    from ..report.page import write_report

    if not args.quiet:
        print("drawing the report", file=sys.stderr)
    display = DISPLAYS[args.units or trajectory.scenario.notes.get("units", "SI")]
    with np.errstate(over="ignore", invalid="ignore"):  # of a run that diverged
        drawn = figures(trajectory, display=display)
        pictures = {name: png(picture) for name, picture in drawn.items()}
        write_report(trajectory, directory / "report.html", text, display, pictures=pictures)
    for name, picture in pictures.items():
        (directory / f"{name}.png").write_bytes(picture)


def say(trajectory: Trajectory, directory: Path, args: argparse.Namespace) -> bool:
    """Print how the run went; returns whether a check failed."""
    import json

    from ..measuring.command_range import beyond_range

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
            from ..measuring.energy import power_beyond_tolerance

            if power_beyond_tolerance(trajectory) > DELIVERED * mean:
                bad.append(f"a clutch delivers {energy['max_clutch_power']:.2g} W")
    for line in bad:
        print(f"check failed: {line}", file=sys.stderr)
    if args.json:
        sys.stdout.write(text)
    else:
        counts = f"{len(trajectory.events)} events, {trajectory.statistics['steps']} steps"
        print(f"{trajectory.status}: {trajectory.message} ({counts})")
        balance = energy and energy["relative"]
        if balance is not None and trajectory.status != "failed":
            print(f"energy balance closes to {balance:.1e} of the turnover")
        for line in beyond_range(trajectory):
            print(line)
        print(f"files in {directory}")
    return bool(bad)
