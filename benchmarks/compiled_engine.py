"""The compiled engine beside the reference engine and peers: cost of a run, of a sweep, of a start.

    python benchmarks/compiled_engine.py [--runs 5] [--karnopp] [--only runs sweep start growth]

Engines take turns on the same runs in one process; medians of CPU times and of their ratios are
printed. Runs: 3 s of PTER, four clutches, random (``tests/random_runs.py``); "split" calls the
model's functions by address (the default), "together" has kernel and model compiled as one. Peers:
heyoka (Taylor series with root isolation, ``tests/taylor_engine.py``, if installed) solves the same
problem to the same tolerance; Karnopp's model does not (its band stays), at 1e-3 and tight
tolerances. Which other routes were measured, and why not: ``--help`` ends with it.
"""

from __future__ import annotations

import argparse
import importlib.util
import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
from chain import chain

ROOT = Path(__file__).parent.parent
sys.path.insert(0, str(ROOT / "tests"))

from random_runs import random_run  # noqa: E402

from simpter_hybrid import compiled, engine  # noqa: E402
from simpter_hybrid.ensemble import ensemble  # noqa: E402
from simpter_hybrid.program import Program, Room  # noqa: E402

ROUTES = """Other routes, CPU seconds on the same machine (November 2026): the same kernel text
under Numba, records by value and first-class functions: 75-100 s cold, 0.6-1.1 us a flow; under
Numba on pointers, functions by address, one optimisation: 40 s cold. The own compiler
(simpter_hybrid/lowering): 5-8 s cold, 0.2-0.25 us a flow. Sines by a polynomial in the dialect
instead of the C library's made a flow half as slow again, and were left out."""


def cpu(function: Callable, *args: object) -> float:
    """CPU seconds of a call."""
    start = time.process_time()
    function(*args)
    return time.process_time() - start


def bare(program: Program, repeats: int = 10) -> float:
    """CPU seconds of one run without records, from ``repeats`` in one call."""
    cases, room = program.cases(repeats), Room(400 * repeats, 0, 0)
    return cpu(program.call, cases, room) / repeats


def engines(karnopp: bool) -> dict[str, Callable]:
    """What is compared, by name: functions of a scenario that give CPU seconds a run."""
    found: dict[str, Callable] = {
        "reference": lambda s: cpu(engine.simulate, s),
        "compiled, with record": lambda s: cpu(compiled.simulate, s),
        "compiled, split": lambda s: bare(Program(s)),
        "compiled, together": lambda s: bare(Program(s, together=True)),
    }
    if importlib.util.find_spec("heyoka"):
        import taylor_engine

        found["heyoka"] = lambda s: cpu(taylor_engine.Automaton(s).run)
    if karnopp:
        from simpter_hybrid.karnopp import simulate

        found["Karnopp, compiled"] = lambda s: cpu(
            lambda: simulate(s, 1e-3, rtol=1e-8, atol=1e-10, compiled=True)
        )
    return found


def side_by_side(runs: int, karnopp: bool) -> None:
    """Every engine on every run, in turns."""
    print("CPU ms a run of 3 s: median, and median ratio to the reference")
    for kind in ("constant", "30 Hz", "150 Hz"):
        spent: dict[str, list[float]] = {}
        for name, measure in engines(karnopp).items():
            try:
                measure(random_run(kind, 0))  # Compilations are counted under `start`.
                spent[name] = []
            except Exception as error:
                print(f"  {kind}: {name} does not run this ({type(error).__name__}: {error})")
        for seed in range(1, runs + 1):
            run = random_run(kind, seed)
            for name, measure in engines(karnopp).items():
                if name in spent:
                    spent[name].append(measure(run))
        for name, times in spent.items():
            ratio = statistics.median(r / t for r, t in zip(spent["reference"], times, strict=True))
            print(f"  {kind:9} {name:22} {1e3 * statistics.median(times):9.2f}   x {ratio:.1f}")


def sweep(count: int) -> None:
    """One call for many cases."""
    print(f"sweep of {count} runs at 30 Hz (friction, controller and start vary)")
    rng = np.random.default_rng(1)
    vary = {
        "clutch.1.torque.a": rng.uniform(0.15, 0.35, count),
        "controller.1.stiffness": rng.uniform(2e3, 8e3, count),
        "q.theta_1": rng.uniform(0.5, 1.0, count),
    }
    run = random_run("controller 30 Hz", 2)
    for together in (False, True):
        ensemble(run, {k: v[:2] for k, v in vary.items()}, together=together)
        start = time.process_time()
        found = ensemble(run, vary, together=together)
        spent = time.process_time() - start
        ended = int((found.status == 0).sum())
        print(
            f"  {'together' if together else 'split':9} {count / spent:8.0f} runs a CPU second, "
            f"{found.event_counts().sum() / spent:.0f} events a CPU second, {ended} finished"
        )


def start() -> None:
    """A fresh process with an empty and with a filled cache."""
    print("CPU s from the start of the process to the end of the first run")
    code = (
        "import sys, time; sys.path.insert(0, sys.argv[1]); from random_runs import random_run\n"
        "from simpter_hybrid import compiled; t = time.process_time()\n"
        "compiled.simulate(random_run('30 Hz', 1)); print(f'{time.process_time() - t:.2f}')"
    )
    with tempfile.TemporaryDirectory() as folder:
        environment = os.environ | {"SIMPTER_CACHE": folder}
        for word in ("empty cache", "filled cache"):
            words = [sys.executable, "-c", code, str(ROOT / "tests")]
            done = subprocess.run(
                words, env=environment, capture_output=True, text=True, check=True
            )
            print(f"  {word:13} {done.stdout.strip()} (imports not counted)")


def growth() -> None:
    """Cost against size and rate, on a chain of pendulums."""
    print("growth: CPU ms a run of 3 s (split), events, ratio to the reference")
    sizes = [(2, m, 30.0) for m in range(2, 9)] + [(n, 4, 30.0) for n in range(1, 7)]
    sizes += [(2, 4, rate) for rate in (0.0, 30.0, 100.0, 300.0, 1000.0)]
    for n, m, rate in sizes:
        run = chain(n, m, rate)
        program = Program(run)
        spent = min(bare(program) for _ in range(3))
        found = compiled.simulate(run)
        ratio = cpu(engine.simulate, run) / spent
        print(
            f"  n {n} m {m} {rate:6.0f} Hz {1e3 * spent:8.2f} ms {len(found.events):5d} events "
            f"x {ratio:.0f}  {found.status}"
        )


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, epilog=ROUTES, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--karnopp", action="store_true", help="compiles for a minute first")
    parts = ("runs", "sweep", "start", "growth")
    parser.add_argument("--only", nargs="*", choices=parts, default=parts)
    chosen = parser.parse_args()
    if "runs" in chosen.only:
        side_by_side(chosen.runs, chosen.karnopp)
    if "sweep" in chosen.only:
        sweep(chosen.count)
    if "start" in chosen.only:
        start()
    if "growth" in chosen.only:
        growth()


if __name__ == "__main__":
    main()
