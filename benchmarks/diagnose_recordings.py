"""Diagnose all recordings of a folder with fixed settings; one row of verdicts a file.

    python benchmarks/diagnose_recordings.py testbed/practice
    python benchmarks/diagnose_recordings.py testbed/sealed

Files that the table already has are skipped, so an interrupted run goes on where it was.  CPU
times go to stderr: the table is the same wherever it was made.
"""

from __future__ import annotations

import argparse
import csv
import os
import sys
import time
from pathlib import Path

from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.maps import MAPS, find_model
from simpter_hybrid.identification.recording import load_recording
from simpter_hybrid.problems import InvalidInput
from simpter_hybrid.scenario_file import load

HERE = Path(__file__).parent
DATA = Path(os.environ.get("SIMPTER_DATA", HERE.parent.parent / "shared" / "data"))
COLUMNS = (
    "file", "verdict", "effects", "cannot_exclude", "depends_on", "refitted", "after", "floor",
    "after_over_floor",
)  # fmt: skip


def row(file: Path, model: str) -> dict[str, str]:
    """Verdict on one file."""
    declared = load(find_model(model))
    name = file.name.split(".")[0]
    try:
        found = diagnose(load_recording(file, MAPS / f"{model}.toml"), declared)
    except InvalidInput as error:
        return {"file": name, "verdict": f"refused: {error.problems[0].what}"}
    done = found.diagnosis
    return {
        "file": name,
        "verdict": done.verdict.kind,
        "effects": " ".join(e.name for e in done.corrected.effects),
        "cannot_exclude": " ".join(t.candidate.name for t in done.verdict.rivals if t),
        "depends_on": " ".join(done.verdict.coordinates),
        "refitted": f"{done.declared.select:.4f}",
        "after": f"{done.corrected.select:.4f}",
        "floor": f"{done.floor:.4f}",
        "after_over_floor": f"{done.corrected.select / done.floor:.4f}",
    }


def main() -> None:
    """Go through the folder."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", help="below the data folder, e.g. testbed/practice")
    parser.add_argument("--only", nargs="*", default=[], help="names of files")
    args = parser.parse_args()
    model = args.folder.split("/")[0]
    table = HERE / f"verdicts_{args.folder.replace('/', '_')}.csv"
    known = set()
    if table.exists():
        with table.open(encoding="utf-8", newline="") as handle:
            known = {entry["file"] for entry in csv.DictReader(handle)}
    else:
        table.write_text(",".join(COLUMNS) + "\n", encoding="utf-8")
    for file in sorted((DATA / args.folder).glob("*.csv*")):
        name = file.name.split(".")[0]
        if name in known or (args.only and name not in args.only):
            continue
        began, cpu = time.monotonic(), time.process_time()
        found = row(file, model)
        with table.open("a", encoding="utf-8", newline="") as handle:
            csv.DictWriter(handle, COLUMNS, lineterminator="\n").writerow(found)
        spent = f"{time.process_time() - cpu:.0f} s CPU, {time.monotonic() - began:.0f} s"
        print(f"{name}: {found['verdict']} {found.get('effects', '')} ({spent})", file=sys.stderr)


if __name__ == "__main__":
    main()
