"""A sweep of 10,000 cases killed three times with SIGKILL: is anything lost or repeated?

    nice -n 15 python benchmarks/sweep_killed.py [--gains 50] [--draws 200] [--jobs 2] [--dir DIR]

PTER on the line at 30 Hz with torque feedback: gains x draws of the 17 inputs that the thesis does
not print, over their plausible ranges. Each time a kill comes at a random share of what is left;
inode and time of writing of every result file tell whether a case was run again. The results have
to be the bytes of cases run alone (some, drawn at random). Throughput is compared with the same
work done one case after the other in one process: reading the scenario with its overrides, running
it, measuring it; by the clock and, as other programs may be at work, by processor time.
"""

from __future__ import annotations

import argparse
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from uncertain_line import GAIN, SCENARIO, uncertain

from simpter_hybrid.sweeps.plan import Request, make_plan
from simpter_hybrid.sweeps.work import run_cases

START = "import sys; from simpter_hybrid.cli import main; sys.exit(main(sys.argv[1:]))"


def varied(args: argparse.Namespace) -> list[str]:
    """The ``--vary`` texts."""
    return [f"{GAIN}=0:0.6 V/(lbf*in):{args.gains}", *uncertain()]


def command_line(args: argparse.Namespace, out: Path) -> list[str]:
    """``simpter sweep ...``."""
    words = ["sweep", SCENARIO, "--set", "controller.rate=30 Hz", "--out", str(out)]
    words += [word for text in varied(args) for word in ("--vary", text)]
    return [*words, "--sample", str(args.draws), "--jobs", str(args.jobs)]


def identities(out: Path) -> dict[str, tuple[int, int]]:
    """Inode and time of writing of every result file."""
    found = {}
    for entry in os.scandir(out / "cases") if (out / "cases").is_dir() else ():
        if entry.name.endswith(".json"):
            about = entry.stat()
            found[entry.name] = (about.st_ino, about.st_mtime_ns)
    return found


def alive(group: int) -> dict[str, float]:
    """Processes of a process group that are still there, and their processor time so far [s]."""
    found = {}
    for entry in Path("/proc").iterdir():
        try:
            fields = (entry / "stat").read_text().rpartition(")")[2].split()
            if int(fields[2]) == group and fields[0] != "Z":
                found[entry.name] = sum(map(int, fields[11:13])) / os.sysconf("SC_CLK_TCK")
        except (OSError, IndexError, ValueError):
            continue
    return found


def run(words: list[str], kill_at: int, out: Path) -> tuple[float, float, int | None]:
    """Run until done or, with ``kill_at`` cases there, kill; wall and CPU time [s], exit code."""
    began = time.perf_counter()
    used: dict[str, float] = {}
    process = subprocess.Popen(
        [sys.executable, "-c", START, *words], start_new_session=True, stdout=subprocess.DEVNULL
    )
    while process.poll() is None:
        used |= alive(process.pid)
        if kill_at and len(identities(out)) >= kill_at:
            os.kill(process.pid, signal.SIGKILL)  # the program alone: its workers have to notice
            break
        time.sleep(0.2)
    code = process.wait()
    spent = time.perf_counter() - began
    deadline = time.monotonic() + 20.0
    while alive(process.pid) and time.monotonic() < deadline:
        time.sleep(0.05)
    if alive(process.pid):
        raise SystemExit("workers outlived the program that was killed")
    return spent, sum(used.values()), code


def one_after_the_other(
    args: argparse.Namespace, out: Path, count: int
) -> tuple[float, float, int]:
    """Wall and CPU seconds a case, one by one in this process; how many differ from the files."""
    request = Request(SCENARIO, varied(args), out, ["controller.rate=30 Hz"], sample=args.draws)
    plan = make_plan(request)
    run_cases(plan.base, plan.options, plan.cases[:1])
    chosen = random.Random(2).sample(plan.cases, count)
    began, used = time.perf_counter(), time.process_time()
    results = [run_cases(plan.base, plan.options, [case])[0] for case in chosen]
    spent, used = time.perf_counter() - began, time.process_time() - used
    wrong = sum((out / "cases" / f"{n}.json").read_bytes() != content for n, content in results)
    return spent / count, used / count, wrong


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--gains", type=int, default=50)
    parser.add_argument("--draws", type=int, default=200)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--dir", help="kept; else a temporary one that is removed")
    args = parser.parse_args()
    total = args.gains * args.draws
    out = Path(args.dir or tempfile.mkdtemp()) / "sweep"
    words = command_line(args, out)
    chance = random.Random(1)
    kept: dict[str, tuple[int, int]] = {}
    repeated = lost = 0
    wall = used = 0.0
    for kills in range(4):
        left = total - len(kept)
        kill_at = len(kept) + int(left * chance.uniform(0.1, 0.6)) if kills < 3 else 0
        spent, cpu, code = run(words, kill_at, out)
        now = identities(out)
        lost += sum(name not in now for name in kept)
        repeated += sum(now.get(name, when) != when for name, when in kept.items())
        print(
            f"run {kills + 1}: {len(now) - len(kept)} cases in {spent:.1f} s, exit code {code}, "
            f"{len(now)} of {total} there", flush=True,
        )  # fmt: skip
        kept, wall, used = now, wall + spent, used + cpu
    rows = len((out / "table.csv").read_text().splitlines()) - 1
    print(f"lost {lost}, repeated {repeated}, files {len(kept)}, rows of the table {rows}")
    single, cpu, wrong = one_after_the_other(args, out, min(200, total))
    print(
        f"{total} cases in {wall:.1f} s with three kills, {args.jobs} processes: "
        f"{total / wall:.1f} cases/s; one after the other {1e3 * single:.1f} ms a case, "
        f"{1.0 / single:.1f} cases/s: {total * single:.0f} s in all, {total * single / wall:.2f} "
        f"times the sweep's; CPU {1e3 * used / total:.1f} ms a case in the sweep, {1e3 * cpu:.1f} "
        f"ms alone; {wrong} of {min(200, total)} cases differ when run alone"
    )
    if not args.dir:
        shutil.rmtree(out.parent)
    if lost or repeated or wrong or len(kept) != total or rows != total:
        raise SystemExit(1)


if __name__ == "__main__":
    main()
