"""Error against processor time of every solver that can express one run of four clutches.

    python benchmarks/work_precision.py [--quick] [--csv FILE] [--picture FILE] [--redraw FILE]
        [--renew WORD]

The run is that of ``references/linkage.py``: constant friction, breakaway equal to slip torque, two
links pushed by sinusoids for 3 s.  Errors are distances from the reference engine at its default
settings; its own distance from heyoka's Taylor series (an engine that shares nothing with it) is
printed.  Times are medians of three runs, processor time of the run alone, in one process in turn;
they compare implementations as they are: the reference engine and the stiff solvers run in Python,
CVODE calls Python functions, the others are compiled.  ``work_precision.csv`` beside this file and
``docs/work-precision.png`` were made with (``--renew Karnopp`` runs only the families of that name
again, and puts their times in proportion to those of the compiled engine beside them)

    python benchmarks/work_precision.py --csv benchmarks/work_precision.csv \\
        --picture docs/work-precision.png
"""

from __future__ import annotations

import argparse
import csv
import statistics
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent / "references"))
sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests"))

from answer import distance
from solvers import Way, reference, taylor, ways

#: Runs of which the median time is taken; slow ones are run once.
REPEATS, SLOW = 3, 5.0
FIELDS = ("family", "setting", "state_error", "event_error_s", "changes", "missed", "invented",
          "cpu_s", "cpu_over_compiled")  # fmt: skip
COUNTS = ("changes", "missed", "invented")


def measured(way: Way, truth) -> dict:
    """One line of the table."""
    found = way.solve()
    times = [found.cpu]
    while found.cpu < SLOW and len(times) < REPEATS:
        times.append(way.solve().cpu)
    d = distance(found, truth)
    return {
        "family": way.family, "setting": way.setting, "state_error": d.state,
        "event_error_s": float(d.event), "changes": d.changes, "missed": d.missed,
        "invented": d.invented, "cpu_s": statistics.median(times),
    }  # fmt: skip


def formatted(row: dict) -> dict:
    """A line as it is written."""
    digits = {"state_error": "{:.1e}", "event_error_s": "{:.1e}", "cpu_s": "{:.2e}",
              "cpu_over_compiled": "{:.3g}"}  # fmt: skip
    return {k: digits.get(k, "{}").format(row[k]) for k in FIELDS}


def read(file: str) -> list[dict]:
    """A table made before."""
    with Path(file).open(encoding="utf-8", newline="") as handle:
        rows = list(csv.DictReader(handle))
    for row in rows:
        for name in FIELDS[2:]:
            row[name] = int(row[name]) if name in COUNTS else float(row[name])
    return rows


def unbeaten(rows: list[dict], what: str) -> list[dict]:
    """Of many settings those that no other is both faster and closer than."""
    best, found = float("inf"), []
    for row in sorted(rows, key=lambda r: r["cpu_s"]):
        if row[what] < best:
            best = row[what]
            found.append(row)
    return found


def picture(rows: list[dict], file: str) -> None:
    """Two panels: error of the final state and of the changes against time."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, panels = plt.subplots(1, 2, figsize=(12, 5), sharex=True, layout="constrained")
    families = list(dict.fromkeys(row["family"] for row in rows))
    marks = "os^vDP*X<>hd"
    for k, family in enumerate(families):
        own = [row for row in rows if row["family"] == family]
        for panel, what in zip(panels, ("state_error", "event_error_s"), strict=True):
            seen = [r for r in own if what == "state_error" or not r["missed"]]
            seen = [r for r in seen if r[what] > 0.0]  # not the truth itself
            if family.startswith("Karnopp"):
                seen = unbeaten(seen, what)
            panel.loglog(
                [r["cpu_s"] for r in seen], [r[what] for r in seen],
                marks[k] + ("-" if family.startswith("exact") else "--"),
                color=plt.get_cmap("tab20")((2 * k) % 20 + (2 * k) // 20), label=family,
                lw=2 if family.startswith("exact") else 1, ms=6,
            )  # fmt: skip
    panels[0].set_ylabel("error of the final state [rad, rad/s]")
    panels[1].set_ylabel("largest shift of a stop or release [s]\n(none where one is missed)")
    for panel in panels:
        panel.set_xlabel("processor time of the run [s]")
        panel.grid(alpha=0.3)
    names = panels[0].get_legend_handles_labels()
    figure.legend(*names, fontsize=9, loc="outside right center", frameon=False)
    figure.suptitle("Two links, four clutches, 3 s, 42 stops and releases (simulated)")
    figure.savefig(file, dpi=110)


def is_unit(row: dict) -> bool:
    """Whether a line is that of which the times are told in units."""
    return row["family"] == "exact, compiled" and row["setting"] == "default"


def renewed(old: list[dict], new: list[dict], word: str) -> list[dict]:
    """The old table with the lines of families that contain ``word`` replaced."""
    unit = next(row["cpu_s"] for row in old if is_unit(row))
    new = [row | {"cpu_s": row["cpu_over_compiled"] * unit} for row in new if word in row["family"]]
    at = next(k for k, row in enumerate(old) if word in row["family"])
    rest = [row for row in old if word not in row["family"]]
    return rest[:at] + new + rest[at:]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="few settings")
    parser.add_argument("--csv", help="file for the table")
    parser.add_argument("--picture", help="file for the picture")
    parser.add_argument("--redraw", help="only draw a table made before")
    parser.add_argument("--renew", default="", metavar="WORD", help="only families of this name")
    args = parser.parse_args()
    if args.redraw:
        picture(read(args.redraw), args.picture)
        return
    truth = reference(0.0)
    rows = []
    for way in ways(args.quick):
        compiled = way.family == "exact, compiled" and way.setting == "default"
        if args.renew not in way.family and not compiled:
            continue
        if way.solve is None:
            print(f"{way.family}: left out, {way.why_not}")
            continue
        if way.family.startswith("heyoka"):
            d = distance(taylor(), truth)
            print(f"the truth is {d.state:.1e} (state), {d.event:.1e} s (events) from heyoka's")
        rows.append(measured(way, truth))
        r = rows[-1]
        print(f"{r['family']:24} {r['setting']:16} {r['state_error']:8.1e} "
              f"{r['event_error_s']:8.1e} s  missed {r['missed']:2} invented {r['invented']:2} "
              f"{r['cpu_s']:9.2e} s", flush=True)  # fmt: skip
    unit = next((r["cpu_s"] for r in rows if is_unit(r)), float("nan"))
    for r in rows:
        r["cpu_over_compiled"] = r["cpu_s"] / unit
    if args.renew:
        rows = renewed(read(args.csv), rows, args.renew)
    if args.csv:
        with Path(args.csv).open("w", encoding="utf-8", newline="") as file:
            writer = csv.DictWriter(file, FIELDS, lineterminator="\n")
            writer.writeheader()
            writer.writerows(formatted(r) for r in rows)
    if args.picture:
        picture(rows, args.picture)


if __name__ == "__main__":
    main()
