"""Run a scenario again and again with values varied; a killed sweep goes on where it was.

The same command goes on with a sweep that was killed or interrupted and repeats nothing. Every case
has a file of its own, DIR/cases/NAME.json, named by what its result depends on; at the end come
table.csv, table.json and pictures. Intervals low..high are drawn from (--sample N), all other
values are combined with each other and with every point drawn.
"""

from __future__ import annotations

import argparse
import sys
from typing import TYPE_CHECKING

from . import DONE, FAILED, INTERRUPTED

if TYPE_CHECKING:
    from ..sweeps.plan import Plan, Request
    from ..sweeps.table import Table

#: Failed cases named on stderr.
MOST_SAID = 10

HELP = "vary values of a scenario, case by case, on all cores"


def arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    add = parser.add_argument
    add("scenario", help="name of a shipped scenario, or a TOML file, or - (stdin)")
    add(
        "--vary", action="append", default=[], metavar="PATH=VALUES",
        help='a list v1,v2,...; a range a:b:n; an interval low..high to draw from; the unit behind '
        'the last number, ":log" behind it all for ratios; e.g., of line-y24-p016, '
        '--vary loads.0.along="5 lbf,7 lbf" '
        '--vary controller.stages.2.gain="0:0.6 V/(lbf*in):31" --vary device.alpha="0.2..0.6 '
        'kg*m^2"',
    )  # fmt: skip
    add("--cases", metavar="FILE.csv", help="cases from a list: paths, then a line of values each")
    add("--sample", type=int, metavar="N", help="points drawn from the intervals")
    add(
        "--method", default="sobol",
        help="of drawing: sobol (default), halton, lhs; saltelli also gives Sobol indices",
    )  # fmt: skip
    add("--seed", type=int, default=0, help="of drawing (0)")
    add("--set", action="append", default=[], metavar="PATH=VALUE", help="change a value for all")
    add("--out", required=True, metavar="DIR", help="the sweep's directory")
    add("--jobs", type=int, metavar="N", help="processes (as many as there are cores)")
    add("--dask", metavar="ADDRESS", help="a Dask scheduler to work on, e.g. tcp://host:8786")
    add("--chunk", type=int, metavar="N", help="cases handed out at a time")
    add("--engine", default="compiled", help='compiled (default; extra "compiled") or reference')
    add("--measures", default="brief", help="brief (default), or all, about a second a case")
    add("--step", default="1 ms", help="sampling step of the measures (1 ms)")
    add("--units", choices=("SI", "thesis"), help="units of the pictures")
    add("--show", action="append", metavar="MEASURE", help="draw this measure (may be repeated)")
    add("--no-pictures", action="store_true", help="table only")
    add("--json", action="store_true", help="the table as data on stdout")
    add("--quiet", action="store_true", help="no progress on stderr")
    add("--progress", action="store_true", help="progress also where stderr is no terminal")


def execute(args: argparse.Namespace) -> int:
    """Check everything that can be checked, run what is left to run, write table and pictures."""
    from dataclasses import replace

    from ..sweeps.cluster import dask_executor
    from ..sweeps.run import Interrupted, Sweep
    from ..sweeps.watching import Interruption, Reporter

    request = request_of(args)
    reporter = Reporter(args.quiet, args.progress)
    with Interruption() as interruption:
        plan = checked(request, args)
        try:
            with dask_executor(args.dask) as (executor, threads):
                plan = replace(plan, jobs=threads or request.jobs)
                table = Sweep(plan, executor, reporter, lambda: interruption.came).work()
        except Interrupted as error:
            print(f"{error}; the same command goes on", file=sys.stderr)
            return INTERRUPTED
        finally:
            reporter.end()
    if not args.no_pictures:
        draw(plan, table, args)
    return say(plan, table, args)


def request_of(args: argparse.Namespace) -> Request:
    """The request that the arguments make."""
    import os

    from ..sweeps.plan import Request

    if args.jobs is None:
        args.jobs = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else 1
    return Request(
        args.scenario, args.vary, args.out, args.set, args.cases, args.sample, args.method,
        args.seed, args.engine, args.measures, args.step, args.jobs, args.chunk,
        args.show or (),
    )  # fmt: skip


def checked(request: Request, args: argparse.Namespace) -> Plan:
    """The plan of the sweep that the arguments ask for.

    Raises
    ------
    InvalidInput
        With what is wrong with any argument.
    """
    from importlib.util import find_spec

    from ..problems import Problem
    from ..sweeps.plan import make_plan

    more = []
    if args.dask is not None and find_spec("distributed") is None:
        right = "pip install 'dask[distributed]', or --jobs N"
        more.append(Problem("--dask", "", "dask is not installed", args.dask, right))
    return make_plan(request, more)


def draw(plan: Plan, table: Table, args: argparse.Namespace) -> None:
    """The pictures of the sweep."""
    from ..plots import DISPLAYS
    from ..plots.style import png
    from ..plots.sweep import sweep_figures
    from ..sweeps.results import write_whole

    for name in args.show or ():
        if name not in table.measures:
            print(f"--show {name}: no case has it, it is not drawn", file=sys.stderr)
    display = DISPLAYS[args.units or plan.scenario.notes.get("units", "SI")]
    for name, picture in sweep_figures(table, display, args.show).items():
        write_whole(plan.directory.path / f"{name}.png", png(picture))


def say(plan: Plan, table: Table, args: argparse.Namespace) -> int:
    """Print how the sweep went; returns the exit code."""
    failed = table.failed
    for k in failed[:MOST_SAID]:
        record = table.records[k]
        values = ", ".join(f"{path}={value}" for path, value in record.given.items())
        print(f"case {k + 1} {record.status}: {record.message} ({values})", file=sys.stderr)
    if len(failed) > MOST_SAID:
        print(f"and {len(failed) - MOST_SAID} more: see table.csv", file=sys.stderr)
    if args.json:
        sys.stdout.write((plan.directory.path / "table.json").read_text(encoding="utf-8"))
    else:
        print(f"{len(table)} cases, {len(failed)} failed; files in {plan.directory.path}")
    return FAILED if failed else DONE
