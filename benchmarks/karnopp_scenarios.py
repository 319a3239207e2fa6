"""Karnopp's band on every shipped scenario: what band would have been right to 1 %?

    python benchmarks/karnopp_scenarios.py [--out FILE.csv] [--only NAME ...]

For every scenario, every set of rules (``thesis`` with SIMULINK's tolerances, ``fair``, ``tuned``)
and every band: the largest distance from the exact run on the way in units of the distance
travelled, the largest deviation of the thesis's measures (duration, average path error,
acceleration and jerk; equations (44)-(46)), stops and releases missed and invented, energy created.
Then one line a scenario and set of rules: the largest band from which on everything smaller keeps
way and measures within 1 %.  ``karnopp_scenarios.csv`` beside this file was made with

    python benchmarks/karnopp_scenarios.py --out benchmarks/karnopp_scenarios.csv
"""

from __future__ import annotations

import argparse
import csv
import math
import sys
from pathlib import Path

from simpter_hybrid.comparison.candidates import karnopp
from simpter_hybrid.comparison.compare import compare
from simpter_hybrid.engine import simulate
from simpter_hybrid.metrics import measures
from simpter_hybrid.scenario_file import load, shipped_scenarios

RULES = ("thesis", "fair", "tuned")
BANDS = (1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8)
#: What the thesis's tables tell of a run.
TOLD = ("run_time", "average_error", "average_acceleration", "average_jerk")
RIGHT = 0.01
FIELDS = ("scenario", "rules", "band", "status", "way", "measures", "changes", "missed", "invented",
          "energy_created_J", "steps")  # fmt: skip


def travel(trajectory) -> float:
    """Length of the tip's path [m], or the largest way of a coordinate [rad or m]."""
    length = measures(trajectory).path_length
    if length is not None:
        return length
    q = trajectory.step_y[:, : trajectory.scenario.device.n]
    return float(max(abs(q - q[0]).max(), 1e-9))


def deviation(run, exact: dict) -> float:
    """Largest relative deviation of the measures told."""
    found = measures(run).as_dict()
    parts = [0.0]
    for name in TOLD:
        right, other = exact[name]["value"], found[name]["value"]
        if right:
            parts.append(abs(other / right - 1.0))
    return max(parts)


def rows_of(name: str) -> list[dict]:
    """All bands and rules of one scenario."""
    scenario = load(name)
    exact = simulate(scenario)
    told, way = measures(exact).as_dict(), travel(exact)
    found = []
    for rules in RULES:
        chosen = [karnopp(band, rules, compiled=bool(scenario.controllers)) for band in BANDS]
        comparison = compare(scenario, chosen, exact)
        for band, row, run in zip(BANDS, comparison.rows, comparison.runs, strict=True):
            failed = row.status == "failed"
            found.append({
                "scenario": name, "rules": rules, "band": band, "status": row.status,
                "way": math.inf if failed else row.path_error / way,
                "measures": math.inf if failed else deviation(run, told),
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
    args = parser.parse_args()
    rows: list[dict] = []
    print("scenario, rules: band for 1 % of the way, of the measures; missed and invented there")
    for name in args.only or shipped_scenarios():
        try:
            own = rows_of(name)
        except RuntimeError as failure:
            print(f"{name}: {failure}", file=sys.stderr)
            continue
        rows += own
        for rules in RULES:
            part = [r for r in own if r["rules"] == rules]
            counts = " ".join(f"{r['missed']}/{r['invented']}" for r in part)
            print(f"{name:28} {rules:7} way {needed(part, 'way'):>6} measures "
                  f"{needed(part, 'measures'):>6}  missed/invented {counts} of "
                  f"{part[0]['changes']}", flush=True)  # fmt: skip
    if args.out:
        with Path(args.out).open("w", encoding="utf-8", newline="") as file:
            writer = csv.DictWriter(file, FIELDS, lineterminator="\n")
            writer.writeheader()
            writer.writerows(
                {k: f"{v:.3g}" if isinstance(v, float) else v for k, v in r.items()} for r in rows
            )


if __name__ == "__main__":
    main()
