"""Diagnose robot recordings of the own generator, of which rules were made on seeds 201 to 260.

    python benchmarks/own_robot.py            # goes on where it was; own_robot.csv, own_robot.md
    python benchmarks/own_robot.py --only null lag --seed 300
    python benchmarks/own_robot.py --seed 601 --size 0.5     # effects of half the size

Files are made, diagnosed with fixed settings and thrown away.  CPU times go to stderr.
"""

from __future__ import annotations

import argparse
import csv
import io
import sys
import tempfile
import time
from collections import Counter
from itertools import zip_longest
from pathlib import Path

from own_robot_files import CLUTCH, COUPLED, JOINT, LATER, OTHERS, right_names, write
from program import commit

from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.maps import MAPS, find_model
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.identification.reporting.sentences import forms_of
from simpter_hybrid.sweeps.results import write_whole

HERE = Path(__file__).parent
TABLE, PAGE = HERE / "own_robot.csv", HERE / "own_robot.md"
COLUMNS = (
    "kind", "seed", "size", "noise", "right", "verdict", "named", "or_form", "not_excluded",
    "depends_on", "place", "before_over_floor", "after_over_floor", "commit",
)  # fmt: skip
#: First seed of the nulls and of the effects.
NULLS, EFFECTS, NULL_FILES = 101, 201, 60


def cases(seed: int = EFFECTS, size: float = 1.0) -> list[tuple[str, int, float, bool]]:
    """(kind, seed, size, coloured): nulls and effects, half of them in coloured noise."""
    nulls = [("null", NULLS + k, 1.0, bool(k % 2)) for k in range(NULL_FILES)]
    kinds = [*OTHERS, *JOINT, *CLUTCH, *(f"{k}_one" for k in CLUTCH), *COUPLED, *LATER]
    known = [k for k in kinds if k != "null"]
    effects = [(k, seed + i, size, bool(i % 2)) for i, k in enumerate(known)]
    # Nulls and effects in turn, so that a table that was broken off has both.
    pairs = zip_longest(effects, nulls)
    return [case for pair in pairs for case in pair if case is not None]


def row(kind: str, seed: int, size: float, coloured: bool) -> dict[str, str]:
    """Verdict on one file; `place` is where the right effect stands in the verdict's sentence."""
    with tempfile.TemporaryDirectory() as folder:
        file = write(Path(folder), kind, seed, size, coloured)
        recording = load_recording(file, MAPS / "robot.toml")
    diagnosis = diagnose(recording, load(find_model("robot")))
    done = diagnosis.search
    right, verdict = right_names(kind), done.verdict
    named = [e.listed_as for e in done.corrected.effects]
    others = [t.candidate.listed_as for t in verdict.rivals]
    others = others if verdict.accepted is not None else []
    forms = [forms_of(diagnosis, e.name) for e in done.corrected.effects]
    forms = [name.partition(" by ")[0] for of_one in forms for name in of_one]
    listed = [*named, *forms, *others]
    places = [k + 1 for k, name in enumerate(listed) if name in right]
    return {
        "kind": kind, "seed": str(seed), "size": f"{size:g}",
        "noise": "coloured" if coloured else "white",
        "right": " ".join(right), "verdict": verdict.kind, "named": " ".join(named),
        "or_form": " ".join(forms), "not_excluded": " ".join(others),
        "depends_on": " ".join(verdict.coordinates),
        "place": str(places[0]) if places else "",
        "before_over_floor": f"{done.refitted.select_error / done.floor:.3f}",
        "after_over_floor": f"{done.corrected.select_error / done.floor:.3f}",
    }  # fmt: skip


def page(rows: list[dict[str, str]]) -> str:
    """The table in a few lines, a column for every size of effects."""
    sizes = sorted({r["size"] for r in rows if r["kind"] != "null"}, key=float, reverse=True)
    nulls = [r for r in rows if r["kind"] == "null"]
    quiet = sum(r["verdict"] == "nothing missing" for r in nulls)
    columns = [_counted([r for r in rows if r["size"] == s and r["kind"] != "null"]) for s in sizes]
    lines = [
        f"Nulls called null: {quiet} of {len(nulls)}.", "",
        "| effects | " + " | ".join(f"size {s}" for s in sizes) + " |",
        "|---|" + "---|" * len(sizes),
        *(f"| {what} | " + " | ".join(c[what] for c in columns) + " |" for what in columns[0]),
    ]  # fmt: skip
    for size in sizes:
        odd = [r for r in rows if r["size"] == size and _is_odd(r)]
        said = (f"{r['kind']} ({r['verdict']} {r['named']})".replace(" )", ")") for r in odd)
        lines += ["", f"Size {size}, not among the first two: {', '.join(said) or 'none'}."]
    by = Counter(r["commit"] or "programs that were not noted" for r in rows)
    said = ", ".join(f"{n} by {c}" for c, n in by.most_common())
    return "\n".join([*lines, "", f"Rows by program: {said}.", ""])


def _counted(rows: list[dict[str, str]]) -> dict[str, str]:
    foreign = [r for r in rows if not r["right"]]
    known = [r for r in rows if r["right"]]
    clear = [r for r in known if _is_clear(r)]
    first = [r for r in clear if r["place"] == "1"]
    two = [r for r in clear if r["place"] in ("1", "2")]
    wrong = [r for r in known if r["named"] and not r["place"]]
    missed = [r for r in clear if r["verdict"] == "nothing missing"]
    near = [r for r in first if float(r["after_over_floor"]) <= 1.05]
    unknown = [r for r in foreign if r["verdict"] == "unknown"]
    return {
        "above 1.05 of the floor: right name first": f"{len(first)} of {len(clear)}",
        "right name among the first two": f"{len(two)} of {len(clear)}",
        "called nothing missing": f"{len(missed)} of {len(clear)}",
        "right name first: error after up to 1.05 of the floor": f"{len(near)} of {len(first)}",
        "up to 1.05 of the floor (hardly to be seen)": f"{len(known) - len(clear)}",
        "named, and the right one not among what is": f"{len(wrong)} of {len(known)}",
        "in nobody's list: unknown": f"{len(unknown)} of {len(foreign)}",
    }


def _is_clear(row: dict[str, str]) -> bool:
    return float(row["before_over_floor"]) > 1.05


def _is_odd(row: dict[str, str]) -> bool:
    return bool(row["right"]) and _is_clear(row) and row["place"] not in ("1", "2")


def main() -> None:
    """Go through the cases that the table does not have."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--only", nargs="*", default=[], help="kinds")
    parser.add_argument("--seed", type=int, default=EFFECTS, help="of the first effect")
    parser.add_argument("--size", type=float, default=1.0, help="of effects, times the usual")
    parser.add_argument("--fresh", action="store_true", help="rows of other programs do not count")
    parser.add_argument("--most", type=int, default=10**6, help="end after so many files")
    args = parser.parse_args()
    known: dict[tuple[str, str, str], dict[str, str]] = {}
    if TABLE.exists():
        with TABLE.open(encoding="utf-8", newline="") as handle:
            known = {(r["kind"], r["seed"], r["size"]): r for r in csv.DictReader(handle)}
    program, made = commit(), 0
    for kind, seed, size, coloured in cases(args.seed, args.size):
        there = known.get((kind, str(seed), f"{size:g}"))
        done = there is not None and not (args.fresh and there["commit"] != program)
        if done or (args.only and kind not in args.only):
            continue
        if made >= args.most:
            break
        began, made = time.process_time(), made + 1
        new = row(kind, seed, size, coloured) | {"commit": program}
        known[kind, new["seed"], new["size"]] = new
        text = io.StringIO()
        writer = csv.DictWriter(text, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(known.values())
        write_whole(TABLE, text.getvalue().encode())
        PAGE.write_text(page([*known.values()]), encoding="utf-8")
        spent = f"{time.process_time() - began:.0f} s CPU"
        print(f"{kind}: {new['verdict']} {new['named']} ({spent})", file=sys.stderr)


if __name__ == "__main__":
    main()
