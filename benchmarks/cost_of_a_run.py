"""What a line-following run costs, and where the time goes.

    python benchmarks/cost_of_a_run.py [--repeats 5]

Prints, for the run at 30 and at 150 Hz: right-hand sides, guard evaluations, segments, and the
share of the CPU time spent in the flow, in guard values, in dense output, in starting ``solve_ivp``
anew, in the controller, in settling modes, and in the rest (step arithmetic and event bookkeeping);
beside it the same segments done by a bare ``solve_ivp`` with the same flow, without events and
checks.
"""

from __future__ import annotations

import argparse
import statistics
import time
from collections import defaultdict

import numpy as np
from scipy.integrate import DOP853, solve_ivp

import simpter_hybrid
from simpter_hybrid import engine
from simpter_hybrid.running import checked, segment


class Stopwatch:
    """Exclusive CPU time by label: an inner label's time is not counted for the outer one."""

    def __init__(self) -> None:
        self.spent: dict[str, float] = defaultdict(float)
        self.stack: list[list] = []

    def wrap(self, label: str, function):
        def timed(*args, **kwargs):
            start = time.process_time()
            self.stack.append([0.0])
            try:
                return function(*args, **kwargs)
            finally:
                total = time.process_time() - start
                inner = self.stack.pop()[0]
                self.spent[label] += total - inner
                if self.stack:
                    self.stack[-1][0] += total

        return timed


#: (label, owner, attribute) of what is timed.
TIMED = (
    ("flow", segment.Run, "right_hand_side"),
    ("guards", segment.Run, "guard_values"),
    ("controller", segment.Run, "sample"),
    ("settling modes", segment.Run, "settle"),
    ("dense output", DOP853, "_dense_output_impl"),
    ("restarts", checked.CheckedDOP853, "__init__"),
    ("interior checks", checked, "first_dip"),
    ("rest", engine, "simulate"),
)


def timed_run(scenario):
    """A run with its time split; returns (trajectory, seconds by label)."""
    watch = Stopwatch()
    kept = [(owner, name, getattr(owner, name)) for _, owner, name in TIMED]
    try:
        for label, owner, name in TIMED:
            setattr(owner, name, watch.wrap(label, getattr(owner, name)))
        trajectory = engine.simulate(scenario)
    finally:
        for owner, name, original in kept:
            setattr(owner, name, original)
    return trajectory, watch.spent


def bare(scenario, trajectory) -> float:
    """CPU seconds of ``solve_ivp`` alone over the same segments (flow included, nothing else)."""
    run = segment.Run(scenario)
    start = time.process_time()
    for k, (t0, t1) in enumerate(trajectory.segment_t):
        if t1 <= t0:
            continue
        for name in ("mode", "gate", "held"):
            row = getattr(trajectory, name)[k].tolist()
            getattr(run.w, name)[: len(row)] = row
        y = trajectory.state(t0).tolist()
        segment_enter(run, y)
        solve_ivp(
            run.right_hand_side, (t0, t1), np.array(y), method="DOP853", dense_output=True,
            rtol=scenario.rtol, atol=scenario.atol, max_step=scenario.max_step,
            first_step=min(t1 - t0, scenario.max_step),
        )  # fmt: skip
    return time.process_time() - start


def segment_enter(run, y) -> None:
    """Enter the present mode of ``run`` at ``y``."""
    from simpter_hybrid.kernel.motion import enter_mode

    enter_mode(run.md, y, run.w)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--repeats", type=int, default=5)
    repeats = parser.parse_args().repeats
    for name in ("line-y24-30hz", "line-y24"):
        scenario = simpter_hybrid.load(name)
        engine.simulate(scenario)
        rows, alone, plain = defaultdict(list), [], []
        for _ in range(repeats):
            trajectory, spent = timed_run(scenario)
            for label, seconds in spent.items():
                rows[label].append(seconds)
            start = time.process_time()
            engine.simulate(scenario)
            plain.append(time.process_time() - start)
            alone.append(bare(scenario, trajectory))
        total = sum(statistics.median(v) for v in rows.values())
        s = trajectory.statistics
        print(f"{name}: {trajectory.t_end:.3f} s simulated, {s['segments']} segments, "
              f"{s['steps']} steps, {s['rhs_evaluations']} right-hand sides, "
              f"{s['guard_evaluations']} guard evaluations")  # fmt: skip
        for label, _, _ in TIMED:
            share = statistics.median(rows[label]) / total
            print(f"  {label:16s} {100 * share:5.1f} %")
        ratio = statistics.median(p / b for p, b in zip(plain, alone, strict=True))
        print(f"  the run takes {ratio:.2f} times the bare solve_ivp over the same segments")


if __name__ == "__main__":
    main()
