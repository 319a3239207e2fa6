"""The parts of docs/karnopp.md on causes and costs; ``karnopp_page.py`` puts them together."""

from __future__ import annotations

import csv
import json
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
RIGHT = 0.01
RULES = """### Which rule keeps the thesis's model from it

One rule after another is exchanged at a band of {band} rad/s with tight tolerances
(`python benchmarks/karnopp_rules.py`). The table has the largest distance from the exact run on the
way, over the distance travelled.
"""
FEEDBACK = """
**It is the limiter of 3.2.4, on every one of them.** The limiter holds positions and leaves speeds
alone, so a clutch that it holds never has slip zero. The controllers read the *sign* of a slip, and
ask such a clutch for torque that they do not ask of a clutch that is exactly stuck (traced for
line-y24 in [found by the exact model](found-by-the-exact-model.md)). With only the limiter
exchanged the error is that of the band.

**velocity-gradual needs more.** Its torque feedback reads the torque of every stuck clutch, and of
three stuck ones only the sum is determined. The special cases of Case 7 give the right sum with
single torques that mean nothing, so at the sample at 0.38 s clutch 1 is sent 0 V in place of 9.4 V.
The general rule shares by breakaway torque, as the exact engine states that it does, and tends to
the exact run. With torques of least norm in newton metres it did not, at any band. Which is right
is a matter of convention there, and of the clutches' stiffness on the real machine.

Tuned rules on line-y24-velocity come right only at 1e-8. At 0.186644 s a clutch breaks away with
its slip growing from zero, and a sample follows 22 microseconds later. With a wider band the clutch
is then still inside it and is caught again by what the sample commands.
"""
STEPS = """### And what step?

With the rules as printed, none. With the tuned rules and their variable step, the table has the
largest band that is right in way and measures, and the steps that the run then takes (tolerance a
thousandth of the band).
"""
PARTINGS = """### Runs that part for good, one by one

Some of the 500 random runs end more than 1 % away with the tuned rules. The table sorts them by
what a test shows to be the cause (`python benchmarks/karnopp_partings.py`; every run with its
instant, the modes before and after and its cause is in `benchmarks/karnopp_partings.json`).

- *Step*: right with steps of 0.5 ms.
- *Sensitive*: the exact run, started as far away as the band, ends as far away.
- *Sample*, *narrower*: right with a band of 1e-11. At *sample*, a controller's sample falls between
  the two runs' versions of one stop or release, and reads different signs.
- *Ambiguous*: no band helps; several modes are consistent, and the two runs took different ones.
"""
AMBIGUOUS = """
**The smallest example that no band cures** is run `constant 23` at 2.284313 s
(`python benchmarks/karnopp_partings.py --why "constant 23" --bands 1e-10`). Clutch 1 stops while
clutch 4 is stuck. With both held, clutch 4 would need 27.4 N m of the 25.7 N m at which it breaks
away. Once something slips its torque falls, and three successors obey the law: 4 slips and 1 holds,
1 slips back and 4 holds, or both slip. The exact engine's rule lets go at once what slips in the
motion of least constraint (Gauss), which is both. In a band the torques stay at breakaway until a
clutch is out of it. Clutch 4, which accelerates a hundred times as fast, is out first, its torque
falls, and what is left clutch 1 can hold. Neither is wrong: Coulomb friction with breakaway above
slip torque does not decide, and the exact engine's event log calls the event ambiguous.

Two faults of our own were found in this way and mended. Before that they made 12 % of the runs end
elsewhere at a band of 1e-8. The limiter left the slip of a held clutch at 1e-17 in place of 0, of
which controllers read the sign (58 runs of 62). And with SIMULINK's longest step, a fiftieth of the
run, a step out of a locked state jumped over short overloads.
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


def rules() -> Iterator[str]:
    """One rule exchanged after another."""
    rows = table("karnopp_rules.csv")
    yield RULES.format(band=rows[0]["band"])
    words = list(dict.fromkeys(r["rules"] for r in rows))
    yield from head("scenario", *words)
    for name in dict.fromkeys(r["scenario"] for r in rows):
        yield row(name, *(r["way"] for r in rows if r["scenario"] == name))
    yield FEEDBACK


def right(entry: dict[str, str]) -> bool:
    """Whether way and measures are within 1 %."""
    return float(entry["way"]) <= RIGHT and float(entry["measures"]) <= RIGHT


def steps() -> Iterator[str]:
    """The step needed, a line a scenario of the thesis's tables."""
    yield STEPS
    rows = [r for r in table("karnopp_scenarios.csv") if r["rules"] == "tuned"]
    yield from head("scenario", "band [rad/s]", "steps", "missed, invented there")
    for name in dict.fromkeys(r["scenario"] for r in table("karnopp_rules.csv")):
        found: dict[str, str] = {}
        own = [r for r in rows if r["scenario"] == name]
        for entry in sorted(own, key=lambda r: float(r["band"])):
            if not right(entry):
                break
            found = entry
        if found:
            wrong = f"{found['missed']}, {found['invented']} of {found['changes']}"
            yield row(name, found["band"], found["steps"], wrong)
        else:
            yield row(name, "-", "-", "-")
    yield ""


def partings() -> Iterator[str]:
    """Runs that part, by cause, and how many of them part in a command first."""
    yield PARTINGS
    rows = table("karnopp_partings.csv")
    yield from head("band", "runs that part", *list(rows[0])[3:])
    for r in rows:
        yield row(r["band"], f"{r['parted']} of {r['runs']}", *list(r.values())[3:])
    text = (ROOT / "benchmarks" / "karnopp_partings.json").read_text(encoding="utf-8")
    listed = [f for f in json.loads(text) if f["band"] <= 1e-6]
    yield ""
    yield "Those at bands of 1e-6 and less:"
    yield ""
    yield from head("run", "band", "error", "part at [s]", "exact run there", "other run", "cause")
    for f in listed:
        name, size, error = f"{f['kind']} {f['seed']}", f"{f['band']:g}", f"{f['error']:.1g}"
        where = ("nowhere for long", "-", "-")
        if f["t"] is not None:
            modes = [
                " ".join(map(str, f[k])) for k in ("exact_before", "exact_after", "other_after")
            ]
            exact = f"{modes[0]} to {modes[1]} at {f['exact_event_t']:.6f}"
            where = (f"{f['t']:.6f} ({f['first']})", exact, modes[2])
        yield row(name, size, error, *where, f["cause"])
    yield AMBIGUOUS
