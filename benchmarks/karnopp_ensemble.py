"""Karnopp's band on random runs: does the error fall with it, and what does that cost?

    python benchmarks/karnopp_ensemble.py [--runs 100] [--out FILE.json] [--settings tuned,thesis]

Random runs of PTER (pose, speeds, torque maps, loads, commands; ``tests/random_runs.py``), so many
of each of the five kinds, against the exact engine. An error is that of the final link angles in
units of the largest displacement of the run.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
import warnings
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests"))

from random_runs import KINDS, random_run

from simpter_hybrid.comparison.candidates import SIMULINK
from simpter_hybrid.comparison.events import changes, compare_releases, match
from simpter_hybrid.compiled import simulate as exact
from simpter_hybrid.karnopp import FAIR, THESIS, TUNED, Rules, Settings
from simpter_hybrid.karnopp.compiled import Compiled
from simpter_hybrid.karnopp.simulate import on_grid

#: A run that takes more steps than this chatters.
STEPS = 30_000
WINDOW = 0.02


def variable(rules: Rules, band: float, rtol: float | None = None) -> Settings:
    """Variable step; without ``rtol`` a hundredth of the band, at most 1e-6."""
    rtol = rtol or min(max(1e-2 * band, 1e-11), 1e-6)
    return Settings(band, rules=rules, rtol=rtol, atol=1e-3 * rtol, max_steps=STEPS)


def fixed(rules: Rules, band: float, step: float) -> Settings:
    """Fixed step."""
    return Settings(band, "fixed", step, rules, max_steps=400_000)


BANDS = (1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8)
SETS = {
    "thesis": {f"thesis, SIMULINK tolerances, band {b:g}": Settings(
        b, rules=THESIS, max_steps=STEPS, **SIMULINK) for b in BANDS[:5]},
    "thesis-tight": {f"thesis, variable, band {b:g}": variable(THESIS, b) for b in BANDS[:5]},
    "fair": {f"fair, variable, band {b:g}": variable(FAIR, b) for b in BANDS},
    "tuned": {f"tuned, variable, band {b:g}": variable(TUNED, b) for b in BANDS},
    "tolerance": {f"tuned, band {b:g}, rtol {r:g}": variable(TUNED, b, r)
                  for b in (1e-4, 1e-6, 1e-8) for r in (1e-3 * b, 1e-1 * b, b)},
    "fixed": {f"tuned, step {h:g} s, band {b:g}": fixed(TUNED, b, h)
              for h in (1e-3, 1e-4) for b in (1e-1, 1e-2, 1e-3, 1e-4, 1e-5)},
}  # fmt: skip


def one(scenario, reference, ready: Compiled, settings: Settings) -> list[float]:
    """Error, changes in all, missed, invented, shift, releases, wrong, absent, steps, rhs, CPU."""
    start = time.process_time()
    run = on_grid(ready, [], settings)
    cpu = time.process_time() - start
    until = min(run.t_end, reference.t_end)
    reach = float(np.abs(reference.step_y[:, :2] - reference.step_y[0, :2]).max())
    error = float(np.abs(run.end - reference.end)[:2].max()) / max(reach, 1e-3)
    if run.status == "failed":
        error = float("inf")
    theirs = changes(reference, until)
    found = match(theirs, changes(run, until), WINDOW)
    out = compare_releases(reference, run, WINDOW)
    wrong = sum(r.other is not None and r.other != r.reference for r in out)
    absent = sum(r.other is None for r in out)
    counts = run.statistics
    return [
        error, len(theirs), len(found.missed), len(found.invented), found.largest_shift, len(out),
        wrong, absent, counts["steps"], counts["rhs_evaluations"], cpu,
    ]  # fmt: skip


def summary(name: str, rows: np.ndarray) -> dict:
    """One line of the table."""
    error = rows[:, 0]
    total = rows[:, 1].sum()
    return {
        "setting": name,
        "runs": len(rows),
        "median_error": float(np.median(error)),
        "error_90": float(np.quantile(error, 0.9, method="lower")),
        "right_to_1_percent": float((error <= 0.01).mean()),
        "chattering": int((~np.isfinite(error)).sum()),
        "missed": float(rows[:, 2].sum() / total),
        "invented": float(rows[:, 3].sum() / total),
        "median_shift": float(np.median(rows[:, 4])),
        "case_7": int(rows[:, 5].sum()),
        "wrong": int(rows[:, 6].sum()),
        "absent": int(rows[:, 7].sum()),
        "median_steps": float(np.median(rows[:, 8])),
        "median_rhs": float(np.median(rows[:, 9])),
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--runs", type=int, default=100, help="of each kind")
    parser.add_argument("--settings", default="thesis,fair,tuned", help=", ".join(SETS))
    parser.add_argument("--out", help="JSON file for the table")
    args = parser.parse_args()
    warnings.filterwarnings("ignore", message="Cannot cache compiled function")
    chosen = {n: s for group in args.settings.split(",") for n, s in SETS[group].items()}
    rows: dict[str, list[list[float]]] = {name: [] for name in chosen}
    counts: list[list[float]] = []
    for kind in KINDS:
        for seed in range(args.runs):
            scenario = random_run(kind, seed)
            start = time.process_time()
            reference = exact(scenario)
            counts.append([reference.statistics["steps"], time.process_time() - start])
            ready = Compiled(scenario)
            for name, settings in chosen.items():
                rows[name].append(one(scenario, reference, ready, settings))
        print(f"{kind}: {args.runs} runs", file=sys.stderr, flush=True)
    table = [summary(name, np.array(found)) for name, found in rows.items()]
    print(f"exact: median {np.median(np.array(counts)[:, 0]):.0f} steps")
    for line in table:
        print(
            f"{line['setting']:48s} error {line['median_error']:.1e}, "
            f"90 %: {line['error_90']:.1e}, "
            f"right to 1 %: {100 * line['right_to_1_percent']:5.1f} %  missed "
            f"{100 * line['missed']:.1f} % invented {100 * line['invented']:.1f} %  Case 7 "
            f"{line['wrong']} wrong + {line['absent']} absent of {line['case_7']}  "
            f"{line['median_steps']:.0f} steps, {line['chattering']} chatter"
        )
    cpu = {name: float(np.median(np.array(found)[:, 10])) for name, found in rows.items()}
    print(f"# CPU, median: exact {np.median(np.array(counts)[:, 1]):.2e} s", file=sys.stderr)
    for name, seconds in cpu.items():
        print(f"# {name}: {seconds:.2e} s", file=sys.stderr)
    if args.out:
        Path(args.out).write_text(json.dumps(table, indent=2) + "\n")


if __name__ == "__main__":
    main()
