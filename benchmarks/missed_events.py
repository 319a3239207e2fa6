"""How many of thousands of random four-clutch runs have a missed or an invented event.

    python benchmarks/missed_events.py [--runs 10000] [--against dense|taylor] [--max-step 0.02]

Runs are those of ``tests/random_runs.py``: constant commands, random commands held at 30 and
150 Hz, the impedance controller at 30 and 150 Hz.  ``dense``: the compiled engine against itself
with its checks ten times as dense.  ``taylor``: against the independent engine of
``tests/taylor_engine.py`` (needs heyoka).  Prints every run that differs, with its kind and seed,
and a table.
"""

from __future__ import annotations

import argparse
import sys
import time
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests"))

from random_runs import KINDS, random_run
from same_events import first_difference, story, story_of

from simpter_hybrid.compiled import simulate

#: Largest difference of an event time [s] and of a final state; a flat guard amplifies 1e-12.
TIME, STATE = 1e-8, 1e-8


def dense(run):
    """Story and final state with checks ten times as dense."""
    trajectory = simulate(run.replace(max_step=0.002))
    return story_of(trajectory), trajectory.end[:8]


def taylor(run):
    """Story and final state by the independent engine."""
    from taylor_engine import Automaton

    other = Automaton(run).run()
    return story((t, after) for t, _, _, after in other.events), other.y


def compare(kind: str, seed: int, other, max_step: float) -> tuple[int, float, str]:
    """Events, largest difference of the final state, and what differs ('' if nothing)."""
    run = random_run(kind, seed)
    found = simulate(run.replace(max_step=max_step))
    if found.status != "finished":
        return 0, np.nan, found.message
    told, end = other(run)
    difference = first_difference(story_of(found), told, TIME)
    apart = float(np.abs(found.end[:8] - end).max())
    if not difference and apart > STATE:
        difference = f"final states differ by {apart:.1e}"
    return len(found.events), apart, difference


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--runs", type=int, default=10_000, help="number of runs (default 10000)")
    parser.add_argument("--against", choices=("dense", "taylor"), default="dense")
    parser.add_argument("--max-step", type=float, default=0.02, help="longest step judged [s]")
    chosen = parser.parse_args()
    other = {"dense": dense, "taylor": taylor}[chosen.against]
    count = max(1, chosen.runs // len(KINDS))
    wrong = 0
    print(f"{'kind':22} {'runs':>6} {'events':>8} {'wrong':>6} {'largest difference':>19}")
    for kind in KINDS:
        begin, events, differing, apart = time.perf_counter(), 0, 0, 0.0
        for seed in range(count):
            number, distance, difference = compare(kind, seed, other, chosen.max_step)
            events += number
            apart = max(apart, distance)
            if difference:
                differing += 1
                print(f"  {kind}, seed {seed}: {difference}")
        wrong += differing
        spent = time.perf_counter() - begin
        print(f"{kind:22} {count:6} {events:8} {differing:6} {apart:19.1e}   {spent:.0f} s")
    return 1 if wrong else 0


if __name__ == "__main__":
    raise SystemExit(main())
