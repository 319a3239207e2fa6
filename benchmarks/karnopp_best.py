"""What Karnopp's band costs at its best: the cheapest of many settings at each accuracy.

    python benchmarks/karnopp_best.py [--runs 6] [--out FILE.csv]

Random runs as in ``karnopp_ensemble.py``, so many of each of the five kinds.  Searched: the fair
and the tuned rules, these with both limiters (``keep``: that of the fair rules); variable steps
with every band and the tolerances that are 1, 0.1, 0.01 and 0.001 of it, with SIMULINK's longest
step and with 5 ms; fixed steps with every band.  Cost: processor time over that of the compiled
exact engine at its default settings (which are much more exact than any of these), both without a
record, medians.  ``karnopp_best.csv`` beside this file
was made by

    python benchmarks/karnopp_best.py --runs 10 --out benchmarks/karnopp_best.csv
"""

from __future__ import annotations

import argparse
import sys
import warnings
from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from karnopp_ensemble import LONGEST, exact_cpu, one, variable
from random_runs import KINDS, random_run
from tables import write

from simpter_hybrid.compiled import simulate as exact
from simpter_hybrid.karnopp import FAIR, TUNED, Settings
from simpter_hybrid.karnopp.compiled import Compiled

BANDS = (1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10)
#: Fixed steps [s], each with bands that are not narrower than what a step may cross.
STEPS = {2e-3: BANDS[:4], 1e-3: BANDS[1:4], 3e-4: BANDS[2:4], 1e-4: BANDS[3:4]}
KEEP = replace(TUNED, limiter=FAIR.limiter)
LOOSEST, TIGHTEST = 1e-2, 1e-12


def settings() -> Iterator[tuple[str, str, str, Settings]]:
    """Rules, solver, what is set beside the band, and the settings."""
    for band in BANDS:
        for share in (1.0, 0.1, 0.01, 0.001):
            rtol = min(band * share, LOOSEST)
            if rtol < TIGHTEST or (share < 1.0 and rtol == LOOSEST):
                continue
            for name, rules in (("tuned", TUNED), ("tuned, keep", KEEP)):
                for longest, word in ((None, "60 ms"), (LONGEST, "5 ms")):
                    chosen = variable(rules, band, rtol, max_step=longest, max_steps=20_000)
                    yield name, "variable", f"rtol {rtol:g}, at most {word}", chosen
    for band in (1e-3, 1e-5):
        yield "fair", "variable", f"rtol {max(1e-3 * band, 1e-11):g}", variable(
            FAIR, band, max(1e-3 * band, 1e-11), max_steps=5_000
        )  # fmt: skip
    for step, bands in STEPS.items():
        for band in bands:
            chosen = Settings(band, "fixed", step, TUNED, max_steps=400_000)
            yield "tuned", "fixed", f"step {step:g} s", chosen


def line(rules: str, solver: str, band: float, setting: str, rows: list[dict]) -> dict:
    """One line of the table."""
    error = np.array([row["error"] for row in rows])
    return {
        "rules": rules, "solver": solver, "band": f"{band:g}", "setting": setting,
        "runs": len(rows), "median_error": f"{np.median(error):.1e}",
        "error_90": f"{np.quantile(error, 0.9, method='lower'):.1e}",
        "right_to_1_percent": f"{(error <= 0.01).mean():.3f}",
        "cpu_ratio": f"{np.median([row['cpu_ratio'] for row in rows]):.2f}",
    }  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--runs", type=int, default=6, help="of each kind")
    parser.add_argument("--out", help="CSV file")
    args = parser.parse_args()
    warnings.filterwarnings("ignore", message="Cannot cache compiled function")
    all_settings = list(settings())
    rows: list[list[dict]] = [[] for _ in all_settings]
    for seed in range(args.runs):
        for kind in KINDS:
            scenario = random_run(kind, seed)
            reference, cpu, ready = exact(scenario), exact_cpu(scenario), Compiled(scenario)
            for own, (_, _, _, chosen) in zip(rows, all_settings, strict=True):
                row = one(scenario, reference, ready, chosen)
                own.append({"error": row["error"], "cpu_ratio": row["cpu"] / cpu})
        print(f"{seed + 1} of each kind", file=sys.stderr, flush=True)
    table = [
        line(rules, solver, chosen.band, setting, own)
        for own, (rules, solver, setting, chosen) in zip(rows, all_settings, strict=True)
    ]
    write(table, args.out)


if __name__ == "__main__":
    main()
