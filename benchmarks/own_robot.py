"""Diagnose robot recordings of the own generator: seeds that no setting was made with.

    python benchmarks/own_robot.py            # goes on where it was; own_robot.csv, own_robot.md
    python benchmarks/own_robot.py --only null lag --seed 300

Files are made, diagnosed with fixed settings and thrown away.  CPU times go to stderr.
"""

from __future__ import annotations

import argparse
import csv
import sys
import tempfile
import time
from pathlib import Path

from own_robot_files import CLUTCH, COUPLED, JOINT, OTHERS, right_names, write

from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.maps import MAPS, find_model
from simpter_hybrid.identification.recording import load_recording
from simpter_hybrid.scenario_file import load

HERE = Path(__file__).parent
TABLE, PAGE = HERE / "own_robot.csv", HERE / "own_robot.md"
COLUMNS = (
    "kind", "seed", "noise", "right", "verdict", "named", "not_excluded", "depends_on", "place",
    "before_over_floor", "after_over_floor",
)  # fmt: skip
#: First seed of the nulls and of the effects.
NULLS, EFFECTS, NULL_FILES = 101, 201, 12


def cases(seed: int = EFFECTS) -> list[tuple[str, int, bool]]:
    """(kind, seed, coloured): nulls and effects, half of them in coloured noise."""
    nulls = [("null", NULLS + k, bool(k % 2)) for k in range(NULL_FILES)]
    kinds = [*OTHERS, *JOINT, *CLUTCH, *(f"{k}_one" for k in CLUTCH), *COUPLED]
    effects = [(k, seed + i, bool(i % 2)) for i, k in enumerate(x for x in kinds if x != "null")]
    # Nulls and effects in turn, so that a table that was broken off has both.
    found = []
    for i, case in enumerate(effects):
        found += [case, nulls[i // 3]] if i % 3 == 0 and i // 3 < NULL_FILES else [case]
    return found


def row(kind: str, seed: int, coloured: bool) -> dict[str, str]:
    """Verdict on one file; `place` is where the right effect stands among what is named."""
    with tempfile.TemporaryDirectory() as folder:
        file = write(Path(folder), kind, seed, 1.0, coloured)
        recording = load_recording(file, MAPS / "robot.toml")
    done = diagnose(recording, load(find_model("robot"))).diagnosis
    right, verdict = right_names(kind), done.verdict
    named = [e.listed_as for e in done.corrected.effects]
    others = [t.candidate.listed_as for t in verdict.rivals]
    others = others if verdict.accepted is not None else []
    listed = [*named, *others]
    places = [k + 1 for k, name in enumerate(listed) if name in right]
    return {
        "kind": kind, "seed": str(seed), "noise": "coloured" if coloured else "white",
        "right": " ".join(right), "verdict": verdict.kind, "named": " ".join(named),
        "not_excluded": " ".join(others), "depends_on": " ".join(verdict.coordinates),
        "place": str(places[0]) if places else "",
        "before_over_floor": f"{done.declared.select / done.floor:.3f}",
        "after_over_floor": f"{done.corrected.select / done.floor:.3f}",
    }  # fmt: skip


def summary(rows: list[dict[str, str]]) -> str:
    """The table in a few lines."""
    nulls = [r for r in rows if r["kind"] == "null"]
    foreign = [r for r in rows if not r["right"] and r["kind"] != "null"]
    known = [r for r in rows if r["right"]]
    clear = [r for r in known if float(r["before_over_floor"]) > 1.05]
    first = [r for r in clear if r["place"] == "1"]
    two = [r for r in clear if r["place"] in ("1", "2")]
    missed = [r for r in clear if r["verdict"] == "nothing missing"]
    near = [r for r in first if float(r["after_over_floor"]) <= 1.05]
    alarms = [r for r in nulls if r["verdict"] != "nothing missing"]
    quiet = [r for r in known if r not in clear]
    odd = [r for r in clear if r not in two]
    said = ", ".join(f"{r['kind']} ({r['verdict']} {r['named']})".replace(" )", ")") for r in odd)
    unknown = [r for r in foreign if r["verdict"] == "unknown"]
    return "\n".join([
        "| files | right |", "|---|---|",
        f"| nulls called null | {len(nulls) - len(alarms)} of {len(nulls)} |",
        f"| effects above 1.05 of the floor: right name first | {len(first)} of {len(clear)} |",
        f"| right name among the first two | {len(two)} of {len(clear)} |",
        f"| called nothing missing | {len(missed)} of {len(clear)} |",
        f"| of those: error after up to 1.05 of the floor | {len(near)} of {len(first)} |",
        f"| effects below 1.05 times the floor (not to be seen) | {len(quiet)} |",
        f"| in nobody's list: unknown | {len(unknown)} of {len(foreign)} |", "",
        f"Not among the first two: {said or 'none'}.", "",
    ])  # fmt: skip


def main() -> None:
    """Go through the cases that the table does not have."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--only", nargs="*", default=[], help="kinds")
    parser.add_argument("--seed", type=int, default=EFFECTS, help="of the first effect")
    parser.add_argument("--most", type=int, default=10**6, help="end after so many files")
    args = parser.parse_args()
    if not TABLE.exists():
        TABLE.write_text(",".join(COLUMNS) + "\n", encoding="utf-8")
    with TABLE.open(encoding="utf-8", newline="") as handle:
        known = list(csv.DictReader(handle))
    have, before = {(r["kind"], r["seed"]) for r in known}, len(known)
    for kind, seed, coloured in cases(args.seed):
        if (kind, str(seed)) in have or (args.only and kind not in args.only):
            continue
        if len(known) - before >= args.most:
            break
        began = time.process_time()
        known.append(row(kind, seed, coloured))
        with TABLE.open("a", encoding="utf-8", newline="") as handle:
            csv.DictWriter(handle, COLUMNS, lineterminator="\n").writerow(known[-1])
        PAGE.write_text(summary(known), encoding="utf-8")
        spent = f"{time.process_time() - began:.0f} s CPU"
        print(f"{kind}: {known[-1]['verdict']} {known[-1]['named']} ({spent})", file=sys.stderr)


if __name__ == "__main__":
    main()
