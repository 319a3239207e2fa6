"""Write docs/karnopp.md from the tables that the benchmarks wrote.

    python docs/karnopp_page.py [--check]

``--check`` only says whether the page is fresh.
"""

from __future__ import annotations

import csv
import sys
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "karnopp.md"
RIGHT = 0.01
LEAD = """# Karnopp's band beside the exact run

The thesis's simulator, rebuilt (`simpter_hybrid/karnopp`): inside a band of slip speeds a clutch
counts as stuck, and three or four stuck clutches are handled by the lumped actuator of its 7.5.
It shares no friction code with the exact engine. Three sets of rules:

- **thesis**: as printed (Table 1, Appendix A with its misprints corrected, the previous-step rule
  (24)-(29)), ode45 with SIMULINK's default tolerances;
- **fair**: the same tables, every choice that the thesis leaves open made for the better, the
  tolerance following the band;
- **tuned**: without the tables: every clutch inside the band sticks, with the torques of least norm
  that stop all slip, and the speeds are set so that it does. The best band simulator we know how
  to write; its rows are those to beat.

    python benchmarks/karnopp_scenarios.py --out benchmarks/karnopp_scenarios.csv
    python benchmarks/karnopp_ensemble.py --out benchmarks/karnopp_ensemble.csv --runs 100 \\
        --settings thesis,thesis-tight,fair,tuned,tolerance,fixed
    python benchmarks/lumped_actuator.py --draws 100 > benchmarks/lumped_actuator.csv
    python benchmarks/work_precision.py --csv benchmarks/work_precision.csv \\
        --picture docs/work-precision.png
    python docs/karnopp_page.py                               # makes this page
"""
SCENARIOS = """## On the shipped scenarios: what band is right to 1 %?

Largest band [rad/s] from which on that band and every smaller one tried (down to 1e-6) keeps the
whole way within 1 % of the distance travelled, and, second number, the thesis's measures (duration,
average error, acceleration, jerk) within 1 % of the exact run's. "-": none. In brackets stops and
releases missed and invented at a band of 1e-3, of so many.
"""
WHY = """\
Where no band helps, the runs part for good at some change. Traced for line-y24 with the thesis's
rules ([found by the exact model](found-by-the-exact-model.md)): the torque translator reads the
*sign* of a slip, a clutch held by the velocity limiter never has slip zero, and so it is asked for
torque that an exactly stuck clutch is not asked for; with only the limiter exchanged the error is
the exact one. The velocity controllers read signs of slip as well; that the same happens there is
likely and has not been traced.
"""
ENSEMBLE = """## On random runs

Random poses, speeds, torque maps, loads and commands, with and without a controller. Error: of the
final angles in units of the largest displacement. "Chattering": runs given up after 10,000 steps.
Missed and invented: per stop or release of the exact run. Cost: processor time over that of the
exact run, both compiled, neither with a record. Where the rules end elsewhere even at the smallest
band: with breakaway above slip torque several modes can be consistent at one instant, and a band
and the exact engine's rule may choose differently; this has not been traced run by run.
"""
LUMPED = """## How often the lumped actuator lets the wrong clutches go

Single instants of PTER at rest, three or four clutches stuck, against enumeration of all modes, by
how far the load grows from below to above what the clutches hold within one step. The smallest
example is `tests/test_the_lumped_actuator_can_release_the_wrong_clutches.py`.
"""
WORK = """## Error against time, beside other solvers

![Error of the final state and of event times against processor time](work-precision.png)

One run with constant friction and breakaway equal to slip torque, which all of them can express.
The exact engines agree with heyoka's Taylor series, which shares nothing with them, to 1e-15 in the
state and 5e-15 s in the instants. MuJoCo's default friction softness keeps an error of 3e-3
whatever the step; made as hard as it gets, and Siconos with projected Gauss-Seidel (its default
solver of relays fails on redundantly stuck clutches), converge at first order towards the same
answer. Smooth friction converges too, in proportion to its width. Nobody disagrees beyond their
own accuracy. Cheapest setting of each with a state error below a bound, in units of the compiled
exact engine at its default:
"""


def table(file: str) -> list[dict[str, str]]:
    """Rows of a benchmark's CSV file."""
    with (ROOT / "benchmarks" / file).open(encoding="utf-8", newline="") as handle:
        return list(csv.DictReader(handle))


def row(*cells: str) -> str:
    return "| " + " | ".join(cells) + " |"


def head(*cells: str) -> Iterator[str]:
    yield row(*cells)
    yield "|" + "---|" * len(cells)


def needed(rows: list[dict[str, str]], what: str) -> str:
    """The largest band from which on `what` stays within 1 %."""
    best = "-"
    for entry in sorted(rows, key=lambda r: float(r["band"])):
        if not float(entry[what]) <= RIGHT:
            break
        best = entry["band"]
    return best


def scenarios() -> Iterator[str]:
    """Needed bands, a line a scenario."""
    rows = table("karnopp_scenarios.csv")
    yield from head("scenario", "changes", "thesis", "fair", "tuned")
    for name in dict.fromkeys(r["scenario"] for r in rows):
        own = [r for r in rows if r["scenario"] == name]
        cells = []
        for rules in ("thesis", "fair", "tuned"):
            part = [r for r in own if r["rules"] == rules]
            middle = next(r for r in part if float(r["band"]) == 1e-3)
            counts = f"({middle['missed']}, {middle['invented']})"
            cells.append(f"{needed(part, 'way')}, {needed(part, 'measures')} {counts}")
        yield row(name, own[-1]["changes"], *cells)


def ensemble() -> Iterator[str]:
    """All runs together."""
    rows = [r for r in table("karnopp_ensemble.csv") if r["kind"] == "all"]
    yield f"{rows[0]['runs']} runs a line."
    yield ""
    yield from head(
        "setting", "median error", "90 %", "right to 1 %", "chattering", "missed", "invented",
        "Case 7: wrong at first", "cost",
    )  # fmt: skip
    for r in rows:
        yield row(
            r["setting"], r["median_error"], r["error_90"],
            f"{100 * float(r['right_to_1_percent']):.0f} %", r["chattering"], r["missed"],
            r["invented"], f"{r['wrong_at_first']} of {r['case_7']}", r["cpu_ratio"],
        )  # fmt: skip


def lumped() -> Iterator[str]:
    """Wrong releases."""
    rows = table("lumped_actuator.csv")
    yield from head("rules", "stuck clutches", "growth", "wrong", "right", "not held")
    for r in rows:
        yield row(*(r[k] for k in ("rules", "stuck clutches", "growth", "wrong", "right",
                                   "not held")))  # fmt: skip


def work() -> Iterator[str]:
    """Cheapest setting below a bound."""
    rows = table("work_precision.csv")
    bounds = (1e-2, 1e-4, 1e-6, 1e-9)
    yield from head("solver", *(f"below {b:g}" for b in bounds))
    for family in dict.fromkeys(r["family"] for r in rows):
        cells = []
        for bound in bounds:
            costs = [
                float(r["cpu_over_compiled"])
                for r in rows
                if r["family"] == family and float(r["state_error"]) < bound
            ]
            cells.append(f"{min(costs):.3g}" if costs else "-")
        yield row(family, *cells)


def page() -> str:
    """The whole page."""
    parts = [
        LEAD, SCENARIOS, *scenarios(), "", WHY, ENSEMBLE, *ensemble(), "", LUMPED, *lumped(), "",
        WORK, *work(), "",
    ]  # fmt: skip
    return "\n".join(parts)


def main() -> int:
    text = page()
    if "--check" in sys.argv:
        fresh = PAGE.exists() and PAGE.read_text(encoding="utf-8") == text
        print("fresh" if fresh else "stale: run python docs/karnopp_page.py")
        return 0 if fresh else 1
    PAGE.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
