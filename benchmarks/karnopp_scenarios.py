"""Karnopp's band on every shipped scenario: what band would have been right to 1 %?

    python benchmarks/karnopp_scenarios.py [--out FILE.csv] [--only NAME ...]

For every scenario, every set of rules (``thesis`` with SIMULINK's tolerances, ``fair``, ``tuned``)
and every band: the largest distance from the exact run on the way in units of the distance
travelled, the largest deviation of the thesis's measures (duration, average path error,
acceleration and jerk; equations (44)-(46)), stops and releases missed and invented, energy created.
Then one line a scenario and set of rules: the largest band from which on everything smaller keeps
way and measures within 1 %.  ``karnopp_scenarios.csv`` beside this file was made with

    python benchmarks/karnopp_scenarios.py --out benchmarks/karnopp_scenarios.csv

(With ``--keep`` the other lines of the file stay: ``--rules fair,tuned --only NAME ... --keep``.)
"""

from __future__ import annotations

import argparse
import csv
import math
import sys
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from simpter_hybrid.comparison.candidates import karnopp
from simpter_hybrid.comparison.compare import compare
from simpter_hybrid.engine import simulate
from simpter_hybrid.files.scenario_file import load, shipped_scenarios
from simpter_hybrid.measuring.metrics import (
    desired_path,
    differences,
    path_weighted_average,
    time_weighted_average,
)
from simpter_hybrid.measuring.sampling import sample

RULES = ("thesis", "fair", "tuned")
BANDS = (1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8)
#: What the thesis's tables tell of a run.
TOLD = ("run_time", "average_error", "average_acceleration", "average_jerk")
RIGHT = 0.01
FIELDS = ("scenario", "rules", "band", "status", "way", "measures", "changes", "missed", "invented",
          "energy_created_J", "steps")  # fmt: skip


def travel(trajectory) -> float:
    """Length of the tip's path [m], or the largest way of a coordinate [rad or m]."""
    length = told(trajectory).get("path_length")
    if length is not None:
        return length
    q = trajectory.step_y[:, : trajectory.scenario.device.n]
    return float(max(abs(q - q[0]).max(), 1e-9))


def told(run) -> dict[str, float]:
    """The measures of ``TOLD`` and the path's length, as ``metrics.measures`` has them."""
    times = np.minimum(np.arange(int(run.t_end / 1e-3 + 1e-9) + 1) * 1e-3, run.t_end)
    seen = sample(run, times)
    size = np.linalg.norm(seen.acceleration, axis=1)
    found = {
        "run_time": run.t_end,
        "average_acceleration": time_weighted_average(seen.t, size),
        "average_jerk": time_weighted_average(seen.t, differences(seen.t, seen.acceleration)),
    }
    path = desired_path(run.scenario)
    if seen.tip is not None:
        error = np.zeros(len(seen.t)) if path is None else abs(path.offset(seen.tip))
        average, found["path_length"] = path_weighted_average(seen.tip, error)
        if path is not None:
            found["average_error"] = average
    return found


def deviation(run, exact: dict[str, float]) -> float:
    """Largest relative deviation of the measures told."""
    found = told(run)
    return max(abs(found[k] / exact[k] - 1.0) if exact.get(k) else 0.0 for k in TOLD)


def rows_of(name: str, all_rules: Sequence[str] = RULES) -> list[dict]:
    """All bands of one scenario and the rules given."""
    scenario = load(name)
    exact = simulate(scenario)
    right, way = told(exact), travel(exact)
    found = []
    for rules in all_rules:
        chosen = [karnopp(band, rules, compiled=bool(scenario.controllers)) for band in BANDS]
        comparison = compare(scenario, chosen, exact)
        for band, row, run in zip(BANDS, comparison.rows, comparison.runs, strict=True):
            failed = row.status == "failed"
            found.append({
                "scenario": name, "rules": rules, "band": band, "status": row.status,
                "way": math.inf if failed else row.path_error / way,
                "measures": math.inf if failed else deviation(run, right),
                "changes": row.matched + row.missed, "missed": row.missed,
                "invented": row.invented, "energy_created_J": row.energy_created or 0.0,
                "steps": row.steps,
            })  # fmt: skip
    return found


def needed(rows: list[dict], what: str) -> str:
    """The largest band from which on `what` stays within 1 %, or none."""
    best = "none"
    for row in sorted(rows, key=lambda r: r["band"]):
        if not row[what] <= RIGHT:
            break
        best = f"{row['band']:g}"
    return best


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", help="CSV file")
    parser.add_argument("--only", nargs="*", default=[], help="names of scenarios")
    parser.add_argument("--rules", default=",".join(RULES))
    parser.add_argument("--keep", action="store_true", help="other lines of the file stay")
    args = parser.parse_args()
    chosen = args.rules.split(",")
    rows: list[dict] = []
    print("scenario, rules: band for 1 % of the way, of the measures; missed and invented there")
    for name in args.only or shipped_scenarios():
        try:
            own = rows_of(name, chosen)
        except RuntimeError as failure:
            print(f"{name}: {failure}", file=sys.stderr)
            continue
        rows += own
        for rules in chosen:
            part = [r for r in own if r["rules"] == rules]
            counts = " ".join(f"{r['missed']}/{r['invented']}" for r in part)
            print(f"{name:28} {rules:7} way {needed(part, 'way'):>6} measures "
                  f"{needed(part, 'measures'):>6}  missed/invented {counts} of "
                  f"{part[0]['changes']}", flush=True)  # fmt: skip
    if args.out:
        lines = [{k: f"{v:.3g}" if isinstance(v, float) else str(v) for k, v in r.items()}
                 for r in rows]  # fmt: skip
        if args.keep:
            lines = merged(Path(args.out), lines)
        with Path(args.out).open("w", encoding="utf-8", newline="") as file:
            writer = csv.DictWriter(file, FIELDS, lineterminator="\n", extrasaction="ignore")
            writer.writeheader()
            writer.writerows(lines)


def merged(file: Path, new: list[dict]) -> list[dict]:
    """A table made before with the lines of the same scenario and rules replaced."""
    with file.open(encoding="utf-8", newline="") as handle:
        lines = list(csv.DictReader(handle))
    made = {(line["scenario"], line["rules"]) for line in new}
    lines = [line for line in lines if (line["scenario"], line["rules"]) not in made] + new
    names = list(dict.fromkeys([*shipped_scenarios(), *(line["scenario"] for line in lines)]))
    return sorted(lines, key=lambda r: (names.index(r["scenario"]), RULES.index(r["rules"]),
                                        -float(r["band"])))  # fmt: skip


if __name__ == "__main__":
    main()
