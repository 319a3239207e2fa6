"""What fixed step the thesis's tables would have needed, with the band that suits it best.

    python benchmarks/karnopp_steps.py [--out FILE.csv] [--only NAME ...]

The scenarios of the thesis's tables (those with controllers, for PTER); tuned rules, fixed steps of
Dormand and Prince's formula, every band; errors as in ``karnopp_scenarios.py``.  (With the rules as
printed no band and step helps where that table says "-".)  ``karnopp_steps.csv`` beside this file
was made with

    python benchmarks/karnopp_steps.py --out benchmarks/karnopp_steps.csv
"""

from __future__ import annotations

import argparse
import csv
import io
import sys
from pathlib import Path

from karnopp_scenarios import deviation, told, travel

from simpter_hybrid.comparison.candidates import karnopp
from simpter_hybrid.comparison.compare import compare
from simpter_hybrid.engine import simulate
from simpter_hybrid.scenario_file import load

SCENARIOS = ("circle-ideal", "line-y24", "line-y24-30hz", "line-y24-p016", "line-y24-velocity",
             "line-y24-velocity-gradual", "standard-input")  # fmt: skip
STEPS = (2e-3, 1e-3, 3e-4, 1e-4, 3e-5)
BANDS = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6)
FIELDS = ("scenario", "step_s", "band", "way", "measures", "missed", "invented")


def rows_of(name: str) -> list[dict]:
    """All steps and bands of one scenario."""
    scenario = load(name)
    exact = simulate(scenario)
    right, way = told(exact), travel(exact)
    found = []
    for step in STEPS:
        chosen = [karnopp(band, "tuned", "fixed", step, compiled=True) for band in BANDS]
        for band, candidate in zip(BANDS, chosen, strict=True):
            comparison = compare(scenario, [candidate], exact)
            row, run = comparison.rows[0], comparison.runs[0]
            failed = row.status == "failed"
            far = float("inf")
            found.append({
                "scenario": name, "step_s": f"{step:g}", "band": f"{band:g}",
                "way": f"{far if failed else row.path_error / way:.3g}",
                "measures": f"{far if failed else deviation(run, right):.3g}",
                "missed": row.missed, "invented": row.invented,
            })  # fmt: skip
    return found


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", help="CSV file")
    parser.add_argument("--only", nargs="*", default=[], help="names of scenarios")
    args = parser.parse_args()
    rows: list[dict] = []
    for name in args.only or SCENARIOS:
        print(name, file=sys.stderr, flush=True)
        rows += rows_of(name)
    text = io.StringIO()
    writer = csv.DictWriter(text, FIELDS, lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    sys.stdout.write(text.getvalue())
    if args.out:
        Path(args.out).write_text(text.getvalue(), encoding="utf-8")


if __name__ == "__main__":
    main()
