"""Diagnose all recordings of folders with fixed settings; one row of verdicts a file.

    python benchmarks/diagnose_recordings.py testbed/practice robot/practice
    python benchmarks/diagnose_recordings.py testbed/sealed robot/sealed --fresh

Files that a table already has are skipped unless it is begun anew, so an interrupted run goes on
where it was.  CPU times go to stderr.  On one kind of processor the table is always the same; on
another one fits of soft forms may end elsewhere (T10 and T23 by up to 3 % of their errors).
"""

from __future__ import annotations

import argparse
import csv
import sys
import time
from collections.abc import Sequence
from itertools import chain
from pathlib import Path

from measured import recordings
from program import commit

from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.identification.contests import Ranked
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.identifiability_report import Sight
from simpter_hybrid.identification.identifiability_request import seen_by
from simpter_hybrid.identification.maps import MAPS, find_model
from simpter_hybrid.identification.recordings.recording import Recording, load_recording
from simpter_hybrid.identification.reporting.held_out_sentences import held_out
from simpter_hybrid.identification.reporting.sentences import forms_of, verdict_sentence
from simpter_hybrid.identification.reporting.sight_sentences import in_classes
from simpter_hybrid.identification.result import Diagnosis
from simpter_hybrid.problems import InvalidInput

HERE = Path(__file__).parent
COLUMNS = (
    "file", "verdict", "effects", "or_form", "cannot_exclude", "as_well", "depends_on",
    "refitted", "after", "floor", "after_over_floor", "held_out_over_floor",
    "sentence", "absent", "blind_to", "confuses", "run_next", "commit",
)  # fmt: skip


def row(file: Path, model: str) -> dict[str, str]:
    """Verdict on one file."""
    declared = load(find_model(model))
    name = file.name.split(".")[0]
    try:
        recording = load_recording(file, MAPS / f"{model}.toml")
        found = diagnose(recording, declared)
    except InvalidInput as error:
        return {"file": name, "verdict": f"refused: {error.problems[0].what}"}
    done = found.search
    return {
        "file": name,
        "verdict": done.verdict.kind,
        "effects": " ".join(e.name for e in done.corrected.effects),
        "or_form": " ".join(f for e in done.corrected.effects for f in forms_of(found, e.name)),
        "cannot_exclude": " ".join(t.candidate.name for t in done.verdict.rivals if t),
        "as_well": " ".join(done.verdict.as_well),
        "depends_on": " ".join(done.verdict.coordinates),
        "refitted": f"{done.refitted.select_error:.4f}",
        "after": f"{done.corrected.select_error:.4f}",
        "floor": f"{done.floor:.4f}",
        "after_over_floor": f"{done.corrected.select_error / done.floor:.4f}",
        "held_out_over_floor": f"{held_out(found):.4f}",
        "sentence": verdict_sentence(found),
        "absent": " ".join(recording.absent),
        **(sight_columns(seen_by(found), found) if wanted(found, recording) else {}),
    }


def wanted(found: Diagnosis, recording: Recording) -> bool:
    """Whether it matters what the data cannot carry: something was not logged, or is contested."""
    contested = found.search.verdict.kind == "cannot be told apart"
    return bool(recording.absent) or contested


def sight_columns(seen: Sight, found: Diagnosis) -> dict[str, str]:
    """What the data are blind to, what they confuse, and the experiments that would tell."""
    named = {e.listed_as for e in found.search.corrected.effects}
    # What was named first, then what the runs do not show, then what else they confuse.
    told: dict[str, list[str]] = {"named": [], "blind": [], "confused": []}
    for (a, b), runs in seen.run_next.items():
        about = "named" if named & {a, b} else "confused"
        told[about].append(f"{a} or {b}: {_run(runs, seen)}")
    # Without experiments of its own a rig has only the runs that were made: no advice.
    for name, runs in (seen.reveals if found.experiments else {}).items():
        told["named" if name in named else "blind"].append(f"{name}: {_run(runs, seen)}")
    return {
        "blind_to": ", ".join(in_classes(seen.blind, found.candidates)),
        "confuses": "; ".join(f"{a} and {b}" for a, b, _ in seen.confused),
        "run_next": "; ".join(chain.from_iterable(told.values())),
    }


def _run(runs: Ranked, seen: Sight) -> str:
    """The experiment that tells most, with its distance; or that none tells enough."""
    tells = [f"{name} ({distance:.0f})" for name, distance in runs if distance >= seen.needed[name]]
    return tells[0] if tells else "no planned run tells enough"


def filled(folder: str, only: Sequence[str], fresh: bool) -> None:
    """Go through a folder: its table gets a row for every file that it lacks."""
    model = folder.split("/")[0]
    table = HERE / f"verdicts_{folder.replace('/', '_')}.csv"
    files = list(recordings(folder))  # refused before a table is begun anew
    known: set[str] = set()
    columns: Sequence[str] = COLUMNS
    if table.exists() and not fresh:
        with table.open(encoding="utf-8", newline="") as handle:
            reader = csv.DictReader(handle)
            columns = tuple(reader.fieldnames or COLUMNS)
            known = {entry["file"] for entry in reader}
    else:
        table.write_text(",".join(COLUMNS) + "\n", encoding="utf-8")
    for file in files:
        name = file.name.split(".")[0]
        if name in known or (only and name not in only):
            continue
        began, cpu = time.monotonic(), time.process_time()
        found = row(file, model) | {"commit": commit()}
        with table.open("a", encoding="utf-8", newline="") as handle:
            rows = csv.DictWriter(handle, columns, extrasaction="ignore", lineterminator="\n")
            rows.writerow(found)
        spent = f"{time.process_time() - cpu:.0f} s CPU, {time.monotonic() - began:.0f} s"
        print(f"{name}: {found['verdict']} {found.get('effects', '')} ({spent})", file=sys.stderr)


def main() -> None:
    """Go through the folders."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", nargs="+", help="below the data folder, e.g. testbed/practice")
    parser.add_argument("--only", nargs="*", default=[], help="names of files")
    parser.add_argument("--fresh", action="store_true", help="begin the tables anew")
    args = parser.parse_args()
    for folder in args.folder:
        filled(folder, args.only, args.fresh)


if __name__ == "__main__":
    main()
