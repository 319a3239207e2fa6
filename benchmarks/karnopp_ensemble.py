"""Karnopp's band on random runs: does the error fall with it, and what does that cost?

    python benchmarks/karnopp_ensemble.py [--runs 100] [--out FILE.csv] [--settings tuned,thesis]

Random runs of PTER (pose, speeds, torque maps, loads, commands; ``tests/random_runs.py``), so many
of each of the five kinds, against the exact engine. An error is that of the final link angles in
units of the largest displacement of the run. Processor times are ratios to the exact engine,
compiled like Karnopp's and without a record like his. ``karnopp_ensemble.csv`` beside this file
was made by

    python benchmarks/karnopp_ensemble.py --out benchmarks/karnopp_ensemble.csv \\
        --runs 100 --settings thesis,thesis-tight,fair,tuned

(With ``--keep`` lines of settings that are not run again stay in the file.)
"""

from __future__ import annotations

import argparse
import csv
import io
import json
import sys
import time
import warnings
from collections.abc import Iterable
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
from simpter_hybrid.machine_code.program import Program, Room

#: A run that takes more steps than this chatters.
STEPS = 10_000
#: Longest step of the tuned rules [s]; SIMULINK's, a fiftieth of the run, jumps over a
#: short overload of locked clutches.
LONGEST = 5e-3
WINDOW = 0.02


def variable(rules: Rules, band: float, rtol: float | None = None, **more) -> Settings:
    """Variable step; without ``rtol`` a hundredth of the band, at most 1e-6."""
    rtol = rtol or min(max(1e-2 * band, 1e-12), 1e-6)
    longest = LONGEST if rules is TUNED else None
    chosen = {"rtol": rtol, "atol": 1e-3 * rtol, "max_steps": STEPS, "max_step": longest} | more
    return Settings(band, rules=rules, **chosen)


BANDS = (1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8)
SETS = {
    "thesis": {f"thesis, SIMULINK tolerances, band {b:g}": Settings(
        b, rules=THESIS, max_steps=STEPS, **SIMULINK) for b in BANDS[:5]},
    "thesis-tight": {f"thesis, variable, band {b:g}": variable(THESIS, b) for b in BANDS[1:4]},
    "fair": {f"fair, variable, band {b:g}": variable(FAIR, b) for b in BANDS},
    "tuned": {f"tuned, variable, band {b:g}": variable(TUNED, b, max_steps=40_000)
              for b in (1e-2, 1e-4, 1e-6, 1e-8)},
}  # fmt: skip


def one(scenario, reference, ready: Compiled, settings: Settings) -> dict[str, float]:
    """One run of Karnopp's model against the exact one."""
    start = time.process_time()
    run = on_grid(ready, [], settings)
    cpu = time.process_time() - start
    until = min(run.t_end, reference.t_end)
    reach = float(np.abs(reference.step_y[:, :2] - reference.step_y[0, :2]).max())
    error = float(np.abs(run.end - reference.end)[:2].max()) / max(reach, 1e-3)
    theirs = changes(reference, until)
    found = match(theirs, changes(run, until), WINDOW)
    out = compare_releases(reference, run, WINDOW)
    return {
        "error": error if run.status != "failed" else float("inf"),
        "changes": len(theirs), "missed": len(found.missed), "invented": len(found.invented),
        "shift": found.largest_shift, "case_7": len(out),
        "first": sum(r.first is not None and r.first != r.reference for r in out),
        "wrong": sum(r.other is not None and r.other != r.reference for r in out),
        "absent": sum(r.other is None for r in out), "cpu": cpu,
        "steps": run.statistics["steps"], "rhs": run.statistics["rhs_evaluations"],
    }  # fmt: skip


def summary(kind: str, name: str, rows: list[dict[str, float]]) -> dict:
    """One line of the table."""
    column = {key: np.array([row[key] for row in rows]) for key in rows[0]}
    error, total = column["error"], max(column["changes"].sum(), 1)
    return {
        "kind": kind,
        "setting": name,
        "runs": len(rows),
        "median_error": f"{np.median(error):.1e}",
        "error_90": f"{np.quantile(error, 0.9, method='lower'):.1e}",
        "right_to_1_percent": f"{(error <= 0.01).mean():.3f}",
        "chattering": int((~np.isfinite(error)).sum()),
        "missed": f"{column['missed'].sum() / total:.3f}",
        "invented": f"{column['invented'].sum() / total:.3f}",
        "median_shift_s": f"{np.median(column['shift']):.1e}",
        "case_7": int(column["case_7"].sum()),
        "wrong_at_first": int(column["first"].sum()),
        "wrong_after_20_ms": int(column["wrong"].sum()),
        "absent": int(column["absent"].sum()),
        "median_steps": f"{np.median(column['steps']):.0f}",
        "median_rhs": f"{np.median(column['rhs']):.0f}",
        "cpu_ratio": f"{np.median(column['cpu_ratio']):.1f}",
    }


def exact_cpu(scenario, repeats: int = 5) -> float:
    """Processor time of a compiled exact run without a record [s]."""
    program = Program(scenario)
    cases, room = program.cases(repeats), Room(400 * repeats, 0, 0)
    start = time.process_time()
    program.call(cases, room)
    return (time.process_time() - start) / repeats


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--runs", type=int, default=100, help="of each kind")
    parser.add_argument("--settings", default="thesis,fair,tuned", help=", ".join(SETS))
    parser.add_argument("--out", help="CSV file for the table")
    parser.add_argument("--elsewhere", help="JSON file: tuned runs that end more than 1 % away")
    parser.add_argument("--keep", action="store_true", help="lines of other settings stay there")
    args = parser.parse_args()
    warnings.filterwarnings("ignore", message="Cannot cache compiled function")
    chosen = {n: s for group in args.settings.split(",") for n, s in SETS[group].items()}
    rows: dict[tuple[str, str], list[dict[str, float]]] = {}
    elsewhere: list[list] = []
    kept = kept_lines(args.out, chosen) if args.keep else []
    for seed in range(args.runs):
        for kind in KINDS:
            scenario = random_run(kind, seed)
            reference, cpu = exact(scenario), exact_cpu(scenario)
            ready = Compiled(scenario)
            for name, settings in chosen.items():
                row = one(scenario, reference, ready, settings)
                row["cpu_ratio"] = row["cpu"] / cpu
                rows.setdefault((kind, name), []).append(row)
                if settings.rules is TUNED and row["error"] > 0.01:
                    elsewhere.append([kind, seed, settings.band])
                rows.setdefault(("all", name), []).append(row)
        print(f"{seed + 1} of each kind", file=sys.stderr, flush=True)
        if args.out:
            Path(args.out).write_text(text_of(rows, kept), encoding="utf-8")
    sys.stdout.write(text_of(rows, kept))
    if args.elsewhere:
        Path(args.elsewhere).write_text(json.dumps(elsewhere), encoding="utf-8")


def kept_lines(file: str, others: Iterable[str]) -> list[dict]:
    """Lines of a table made before whose settings are not among ``others``."""
    with Path(file).open(encoding="utf-8", newline="") as handle:
        return [row for row in csv.DictReader(handle) if row["setting"] not in others]


def text_of(rows: dict[tuple[str, str], list[dict[str, float]]], kept: list[dict]) -> str:
    """The table as CSV: all runs first, then the kinds; settings in the order of ``SETS``."""
    kinds = ("all", *KINDS)
    names = [name for group in SETS.values() for name in group]
    table = kept + [summary(*key, runs) for key, runs in rows.items()]
    table = [line for line in table if line["setting"] in names]
    table.sort(key=lambda line: (kinds.index(line["kind"]), names.index(line["setting"])))
    text = io.StringIO()
    writer = csv.DictWriter(text, table[0], lineterminator="\n")
    writer.writeheader()
    writer.writerows(table)
    return text.getvalue()


if __name__ == "__main__":
    main()
