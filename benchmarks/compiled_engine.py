"""The compiled engine beside the reference engine and its peers: a run, a sweep, a start, growth.

    python benchmarks/compiled_engine.py [--runs 5] [--only runs sweep growth start compilers]

Engines take turns on the same runs in one process; CPU times, so that other programs on the machine
disturb less, and ratios, which they disturb least. Runs: 3 s of PTER, four clutches, random
(``tests/random_runs.py``), and the linkage of ``references/linkage.py``. "split" calls the model's
functions by address (the default), "together" has kernel and model compiled as one. heyoka.py, CyRK
and scikit-sundae solve the same problem under the tests' own automaton
(``tests/event_automaton.py``): Taylor series with root isolation, DOP853 in C++, CVODE; the latter
two call Python for their derivatives. Karnopp's model and MuJoCo solve another: a band, softened
friction. ``docs/compiled-engine.md`` was printed by this command.
"""

from __future__ import annotations

import argparse
import os
import statistics
import subprocess
import sys
import tempfile
import warnings
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path
from unittest import mock

import numpy as np
from chain import chain
from compiled_engine_peers import PEERS, Outcome, Peer, accuracy, bare, timed
from linkage import linkage
from random_runs import random_run

from simpter_hybrid import compiled, engine
from simpter_hybrid.ensemble import ensemble
from simpter_hybrid.machine_code import program
from simpter_hybrid.scenario import Scenario

HERE = Path(__file__).parent
KINDS = ("constant", "30 Hz", "150 Hz", "linkage")


def table(columns: Iterable[str], rows: Iterable[Iterable[object]]) -> None:
    """A table in Markdown."""
    columns = list(columns)
    print("| " + " | ".join(columns) + " |\n|" + "---|" * len(columns))
    for row in rows:
        print("| " + " | ".join(str(v) for v in row) + " |", flush=True)
    print()


def split_only():
    """Let "split" be that even where a merged kernel is on disk."""
    return mock.patch.object(program, "is_kept", return_value=False)


def serves(peer: Peer, kind: str) -> bool:
    return peer.installed and (kind == "linkage" or not peer.linkage)


def solve(peer: Peer, run: Scenario) -> Outcome:
    with split_only():
        return peer.solve(run)


def runs(count: int) -> None:
    """Every engine on every run, in turns."""
    print("## A run of 3 s\n")
    for kind in KINDS:
        scenarios = [
            random_run(kind, 1 + k) if kind != "linkage" else linkage() for k in range(count)
        ]
        peers = [peer for peer in PEERS if serves(peer, kind)]
        for peer in peers:
            for run in scenarios if peer.needs else scenarios[:1]:
                solve(peer, run)  # What is compiled is counted under "Start".
        found: dict[str, list[Outcome]] = {peer.name: [] for peer in peers}
        for run in scenarios:
            for peer in peers:
                found[peer.name].append(solve(peer, run))
        exact = found["reference"]
        own = statistics.median(o.cpu for o in found["compiled, together"])
        rows = []
        for name, outcomes in found.items():
            cpu = statistics.median(o.cpu for o in outcomes)
            pairs = zip(exact, outcomes, strict=True)
            ratio = statistics.median(e.cpu / o.cpu for e, o in pairs)
            marks = ("", "") if name == "reference" else accuracy(outcomes, exact)
            rows.append([name, f"{1e3 * cpu:.2f}", f"{ratio:.3g}", f"{cpu / own:.3g}", *marks])
        table(
            [f"{kind}: CPU ms, median of {count}", "ms", "times the reference's speed",
             "times the cost of together", "other transitions", "largest errors: instants, state"],
            rows,
        )  # fmt: skip


def swept(run: Scenario, count: int) -> dict[str, np.ndarray]:
    """Friction, controller and start of a sweep."""
    rng = np.random.default_rng(1)
    return {
        "clutch.1.torque.a": rng.uniform(0.15, 0.35, count),
        "controller.1.stiffness": rng.uniform(2e3, 8e3, count),
        "q.theta_1": rng.uniform(0.5, 1.0, count),
    }


def case(run: Scenario, vary: dict[str, np.ndarray], k: int) -> Scenario:
    """One case of the sweep as a scenario."""
    a, stiffness, theta = (float(column[k]) for column in vary.values())
    first = run.clutches[0]
    clutches = (replace(first, torque=replace(first.torque, a=a)), *run.clutches[1:])
    (path, every), *others = run.controllers
    path = replace(path, stiffness=stiffness)
    return run.replace(clutches=clutches, controllers=((path, every), *others), q=(theta, run.q[1]))


def sweep(count: int, scaled: int = 5) -> None:
    """A sweep at 30 Hz; the engines that have none run some of its cases one by one."""
    print(f"## A sweep of {count} runs of 3 s at 30 Hz\n")
    run = random_run("controller 30 Hz", 2)
    vary = swept(run, count)
    rows = []
    for peer in PEERS:
        if serves(peer, "sweep") and not peer.name.startswith("compiled"):
            solve(peer, case(run, vary, 0))
            spent = [solve(peer, case(run, vary, k)).cpu for k in range(scaled)]
            rate = 1.0 / statistics.median(spent)
            rows.append([peer.name, f"{rate:.3g}", f"{count / rate:.3g}", "", f"{scaled} cases"])
    spent: dict[str, list[float]] = {"compiled, split": [], "compiled, together": []}
    for turn in range(8):
        for name, times in spent.items():
            with split_only():
                cpu, found = timed(ensemble, run, vary, together=name.endswith("together"))
            assert (found.status == 0).all()
            times += [cpu] if turn > 0 else []  # The first turn compiles.
    for name, times in spent.items():
        middle = statistics.median(times)
        rows.append([
            name, f"{count / middle:.0f} (best {count / min(times):.0f})", f"{middle:.2f}",
            f"{found.event_counts().sum() / middle:.0f}", f"{len(times)} sweeps",
        ])  # fmt: skip
    table(["engine", "runs a CPU second", "CPU s a sweep", "events a CPU second", "from"], rows)


def fresh(code: str, cache: str) -> str:
    """What a fresh process prints."""
    words = [sys.executable, "-c", f"import sys, time; sys.path.insert(0, {str(HERE)!r})\n{code}"]
    environment = os.environ | {"SIMPTER_CACHE": cache}
    return subprocess.run(
        words, env=environment, capture_output=True, text=True, check=True
    ).stdout.strip()


def start() -> None:
    """A fresh process with an empty and with a filled cache."""
    print("## Start: CPU s of a fresh process until its first run has ended, imports included\n")
    rows = []
    for k, peer in enumerate(PEERS):
        if not serves(peer, "30 Hz") or peer.name.startswith("Karnopp") or "record" in peer.name:
            continue
        code = (
            f"from compiled_engine_peers import PEERS\nfrom random_runs import random_run\n"
            f"PEERS[{k}].solve(random_run('30 Hz', 1))\nprint(f'{{time.process_time():.1f}}')"
        )
        with tempfile.TemporaryDirectory() as folder:
            rows.append([peer.name, fresh(code, folder), fresh(code, folder)])
    table(["engine", "nothing compiled yet", "compiled before"], rows)


def compilers() -> None:
    """The own compiler against Numba on the text of a model's six functions."""
    print("## A model's six functions: the own compiler and Numba, CPU s\n")
    made = {
        "own compiler": "from simpter_hybrid.machine_code import compiling\n"
        "make = compiling.model_functions; text = run.text.finish()",
        "Numba": "from model_by_numba import load, model_text\n"
        "text = model_text(run); make = lambda text: load(text, 'model')",
    }
    rows = []
    for name, how in made.items():
        code = (
            f"from compiled_engine_peers import timed\nfrom random_runs import random_run\n"
            f"import warnings; warnings.simplefilter('ignore')\n"
            f"run = random_run('30 Hz', 2)\n{how}\nprint(f'{{timed(make, text)[0]:.2f}}')"
        )
        with tempfile.TemporaryDirectory() as folder:
            rows.append([name, fresh(code, folder), fresh(code, folder)])
    table(["compiler", "cold", "from disk"], rows)


def growth() -> None:
    """Cost against size, rate and events, on a chain of pendulums."""
    print("## Growth: a chain of masses, 3 s (split)\n")
    sizes = [(2, m, 30.0, 1.0) for m in range(2, 9)] + [(n, 4, 30.0, 1.0) for n in range(1, 7)]
    sizes += [(2, 4, rate, 1.0) for rate in (0.0, 30.0, 100.0, 300.0, 1000.0)]
    sizes += [(2, 4, 0.0, tempo) for tempo in (2.0, 4.0, 8.0, 16.0)]
    rows = []
    for n, m, rate, tempo in sizes:
        run = chain(n, m, rate, tempo=tempo)
        with split_only():
            spent = min(bare(run, False, 10).cpu for _ in range(3))
        found = compiled.simulate(run)
        cpu, other = timed(engine.simulate, run)
        assert [e.after for e in found.events] == [e.after for e in other.events]
        per_second = len(found.events) / 3.0
        rows.append([n, m, f"{rate:g}", f"{per_second:.0f}", f"{1e3 * spent:.2f}",
                     f"{1e3 * cpu:.0f}", f"{cpu / spent:.0f}"])  # fmt: skip
    table(["coordinates", "clutches", "rate / Hz", "events / s", "compiled / ms", "reference / ms",
           "ratio"], rows)  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--count", type=int, default=1000)
    parts = ("runs", "sweep", "growth", "start", "compilers")
    parser.add_argument("--only", nargs="*", choices=parts, default=parts)
    chosen = parser.parse_args()
    warnings.filterwarnings("ignore", message="Cannot cache compiled function")
    absent = ", ".join(sorted({peer.name for peer in PEERS if not peer.installed}))
    if absent:
        print(f"Not installed here: {absent}.\n")
    work = {"runs": lambda: runs(chosen.runs), "sweep": lambda: sweep(chosen.count), "start": start,
            "compilers": compilers, "growth": growth}  # fmt: skip
    for name in chosen.only:
        work[name]()


if __name__ == "__main__":
    main()
