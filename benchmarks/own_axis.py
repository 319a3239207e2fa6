"""A rig of one coordinate that nobody wrote code for: diagnose what our own generator hides.

    python benchmarks/own_axis.py               # goes on where it was; own_axis.csv, own_axis.md
    python benchmarks/own_axis.py --seeds 5
    python benchmarks/own_axis.py --fresh       # rows of other programs are made anew

Model and map are those of docs/diagnose.md.  Files are made, diagnosed and thrown away.
"""

from __future__ import annotations

import argparse
import csv
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

from own_axis_files import KINDS, OF_FORCE, SENSOR, SENSORS, write
from program import commit

from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.identification.reporting.sentences import forms_of
from simpter_hybrid.identification.tracing.verdict import LACKING
from simpter_hybrid.scenario_file import load

HERE = Path(__file__).parent
TABLE, PAGE = HERE / "own_axis.csv", HERE / "own_axis.md"
#: Times the floor up to which an error after counts as near it.
NEAR = 1.06
COLUMNS = (
    "kind", "sensor", "seed", "verdict", "named", "or_form", "not_excluded", "depends_on",
    "before_over_floor", "after_over_floor", "score", "commit",
)  # fmt: skip


def row(kind: str, sensor: str, seed: int, program: str) -> dict[str, str]:
    """The verdict of a program on one file."""
    with tempfile.TemporaryDirectory() as folder:
        file, model, map_file = write(Path(folder), kind, sensor, seed)
        found = diagnose(load_recording(file, map_file), load(str(model)))
    done = found.diagnosis
    said = {
        "kind": kind, "sensor": sensor, "seed": str(seed), "verdict": done.verdict.kind,
        "named": " ".join(e.name for e in done.corrected.effects),
        "or_form": " ".join(f for e in done.corrected.effects for f in forms_of(found, e.name)),
        "not_excluded": " ".join(t.candidate.name for t in done.verdict.rivals if t),
        "depends_on": " ".join(done.verdict.coordinates),
        "before_over_floor": f"{done.declared.select / done.floor:.3f}",
        "after_over_floor": f"{done.corrected.select / done.floor:.3f}",
    }  # fmt: skip
    return said | {"score": score(said), "commit": program}


def logs(sensor: str, kind: str) -> bool:
    """Whether there is such a recording: one of set points has no force whose sensor errs."""
    return sensor != "set points" or not {*KINDS[kind][0]} & {*OF_FORCE}


def score(said: dict[str, str]) -> str:
    """``right``, ``set with it``, ``misnamed``, ``spurious``, ``unknown`` or ``missed``."""
    right, named = KINDS[said["kind"]][1], said["named"].split()
    if said["verdict"] in ("nothing missing", *LACKING):
        hidden = {*KINDS[said["kind"]][0]} - {*SENSOR}
        expected = "unknown" if not right and hidden else "nothing missing"
        if not right:
            return "right" if said["verdict"] == expected else said["verdict"]
        return "unknown" if said["verdict"] in LACKING else "missed"
    wrong = [name for name in named if name not in right]
    if said["verdict"] == "cannot be told apart":
        return "set with it" if {*named, *said["not_excluded"].split()} & {*right} else "misnamed"
    if not wrong:
        return "right"
    if {*said["or_form"].split()} & {*right}:
        return "another form, with it"
    return "spurious" if len(wrong) < len(named) else "misnamed"


def header(*names: str) -> list[str]:
    """Two lines that begin a table."""
    return ["| " + " | ".join(names) + " |", "|" + " --- |" * len(names)]


def counted(rows: list[dict[str, str]]) -> list[str]:
    """How often what was said of all kinds, a row for each sensor."""
    scores = [s for s, _ in Counter(r["score"] for r in rows).most_common()]
    lines = [
        "| logged | recordings | " + " | ".join(scores) + " |",
        "|" + " --- |" * (2 + len(scores)),
    ]
    for sensor in SENSORS:
        tally = Counter(r["score"] for r in rows if r["sensor"] == sensor)
        cells = " | ".join(str(tally[s] or "") for s in scores)
        lines.append(f"| {sensor} | {tally.total()} | {cells} |")
    programs = ", ".join(f"{n} by {c}" for c, n in Counter(r["commit"] for r in rows).most_common())
    return [*lines, "", f"Rows by program: {programs}."]


def errors_left(rows: list[dict[str, str]]) -> str:
    """How near to the floor what was named comes, and of which kinds more is left."""
    named = [r for r in rows if r["named"]]
    far = [r for r in named if float(r["after_over_floor"]) > NEAR]
    tally = Counter(r["score"] for r in named)
    said = ", ".join(f"{n} {s}" for s, n in tally.most_common())
    near = Counter(r["score"] for r in named if r not in far)
    kinds: dict[str, list[str]] = {}
    for r in sorted(far, key=lambda r: float(r["after_over_floor"])):
        key = f"{r['kind']} ({r['sensor']}, {r['score']})"
        kinds.setdefault(key, []).append(r["after_over_floor"])
    more = "; ".join(f"{kind} {', '.join(ratios)}" for kind, ratios in kinds.items())
    return (
        f"Something is named in {len(named)} ({said}). Of these the error after is at most "
        f"{NEAR:g} times the floor in {len(named) - len(far)} "
        f"({', '.join(f'{n} {s}' for s, n in near.most_common())}); more in {len(far)}: {more}."
    )


def page(rows: list[dict[str, str]]) -> str:
    """own_axis.md."""
    lines = [
        ABOUT,
        *counted(rows),
        "",
        errors_left(rows),
        "",
        "| hidden | " + " | ".join(SENSORS) + " |",
        "|" + " --- |" * (1 + len(SENSORS)),
    ]
    for kind in KINDS:
        cells = []
        for sensor in SENSORS:
            of = [r for r in rows if r["kind"] == kind and r["sensor"] == sensor]
            if not logs(sensor, kind):
                cells.append("")
                continue
            tally = Counter(r["score"] for r in of)
            ratios = [r["after_over_floor"] for r in of]
            cells.append(
                "; ".join(f"{n} {s}" for s, n in tally.items()) + f" ({', '.join(ratios)})"
            )
        lines.append(f"| {kind} | " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


ABOUT = """# A slide that nobody wrote code for (synthetic)

    python benchmarks/own_axis.py

Verdicts on recordings of `own_axis_files.py`, by the model and the map of docs/diagnose.md; in
brackets the error after over the floor on the runs that select. `by-rest` (more friction for a
centimetre after every reversal) is in nobody's list: right is "unknown". Friction that differs with
direction and a constant force are the same where all friction is Coulomb's; a force sensor that
shows too much, and more mass with less friction, are the same wherever nothing else is known of
either: a set is all that can be said. Three have a noisier sensor of force: six times the noise
(2 % of the friction), or slow noise (10 ms, 1 %), of which "lack or noise" is as far as one can go
unless every push is given twice (`repeated`). Friction of another level in each trial (3 %) is
"unknown" as well, and depends on the run; beside it effects should be found all the same. "moved"
takes the positions as what moved the slide and the force as what that took: noise of the positions
is noise of the inertial force there, several times that of the force's sensor, and rows at rest and
at turns are not compared, so less can be seen. "set points" are those of a servo, whose loop the
model runs itself: no force is known.
"""


def main() -> None:
    """Go through what is not yet there."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, default=2)
    parser.add_argument("--kinds", nargs="*", default=list(KINDS))
    parser.add_argument("--sensors", nargs="*", default=list(SENSORS))
    parser.add_argument("--fresh", action="store_true", help="make rows of other programs anew")
    args, program = parser.parse_args(), commit()
    rows: list[dict[str, str]] = []
    if TABLE.exists():
        with TABLE.open(encoding="utf-8", newline="") as handle:
            rows = list(csv.DictReader(handle))
    if args.fresh:
        rows = [r for r in rows if r.get("commit") == program]
    there = {(r["kind"], r["sensor"], r["seed"]) for r in rows}
    for seed in range(1, args.seeds + 1):
        for kind in args.kinds:
            for sensor in args.sensors:
                if (kind, sensor, str(seed)) in there or not logs(sensor, kind):
                    continue
                cpu = time.process_time()
                rows.append(row(kind, sensor, seed, program))
                with TABLE.open("w", encoding="utf-8", newline="") as handle:
                    writer = csv.DictWriter(handle, COLUMNS, lineterminator="\n")
                    writer.writeheader()
                    writer.writerows(rows)
                spent = time.process_time() - cpu
                told = " ".join(rows[-1][c] for c in COLUMNS)
                print(f"{told} ({spent:.0f} s CPU)", file=sys.stderr, flush=True)
    PAGE.write_text(page(rows), encoding="utf-8")


if __name__ == "__main__":
    main()
