"""Recordings of the own generator, diagnosed: who is named, who is misnamed, what nulls give.

    python benchmarks/diagnose_own.py --hours 4            go on where it was, for at most so long
    python benchmarks/diagnose_own.py --cases 'null.*'     only these, shell patterns
    python benchmarks/diagnose_own.py --first 60           only the first cases of the list
    python benchmarks/diagnose_own.py --list               what there is to do
    python benchmarks/diagnose_own.py --table              tables and page from what is there

Work is handed out by the project's own sweeps: a row is a file in OUT/cases, whole or not there,
so a run that was killed loses no finished case and repeats none, and a line of the table counts
as finished where the files of its run are gone.  Sources that change meanwhile end the run: start
it from a clone (PYTHONPATH) while others write.  A row says which program made it; `--fresh` takes
rows of other versions of the program as not there.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import tempfile
import time
import traceback
from collections.abc import Sequence
from concurrent.futures import Executor, Future
from fnmatch import fnmatchcase
from pathlib import Path
from typing import Any

from own_advice import advised, planned
from own_cases import OwnCase, cases
from own_score import score
from own_table import Row, kept, write_tables
from own_testbed import make, write
from program import commit

from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.identifiability_request import seen_by
from simpter_hybrid.identification.maps import MAPS, find_model
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.identification.reporting.held_out_sentences import held_out
from simpter_hybrid.identification.result import Diagnosis
from simpter_hybrid.problems import InvalidInput
from simpter_hybrid.sweeps.code_version import code_version
from simpter_hybrid.sweeps.execution import Crew, on_processes
from simpter_hybrid.sweeps.results import write_whole
from simpter_hybrid.sweeps.watching import Interruption
from simpter_hybrid.sweeps.work import Case

HERE = Path(__file__).parent
#: Trials of a round that a row keeps.
TRIALS = 6


def rounds_of(found: Diagnosis) -> list[dict[str, Any]]:
    """Why: what each round tried and on what its residual depended."""
    return [
        {
            "verdict": r.verdict.kind,
            "trials": {
                t.candidate.name: [round(t.select_error, 4), round(t.gain, 4), round(t.share, 3)]
                for t in r.trials[:TRIALS]
            },
            "before": _strongest(r.before),
            "after": _strongest(r.after),
        }
        for r in found.search.rounds
    ]


def _strongest(dependences) -> dict[str, list[float]]:
    every = [(f"{b}:{d.coordinate}", d) for b, some in dependences.items() for d in some]
    every.sort(key=lambda pair: -pair[1].gain)
    return {name: [round(d.gain, 4), d.p_value, d.samples] for name, d in every[:TRIALS]}


def found_in(file: Path, without: Sequence[str] = ()) -> Diagnosis:
    """`simpter diagnose` of a recording."""
    declared = load(find_model("testbed"))
    return diagnose(load_recording(file, MAPS / "testbed.toml"), declared, without=without)


def verdict_on(found: Diagnosis, poor: bool) -> dict[str, Any]:
    """What a diagnosis says; of poor data also what they do not show."""
    done = found.search
    row = {
        "verdict": done.verdict.kind,
        "effects": [e.name for e in done.corrected.effects],
        "cannot_exclude": sorted(
            {t.candidate.name for r in done.rounds for t in r.verdict.rivals if t}
            | {t.candidate.name for t in done.verdict.rivals if t}
        ),
        "as_well": list(done.verdict.as_well),
        "depends_on": list(done.verdict.coordinates),
        "refitted": round(done.refitted.select_error, 4),
        "after": round(done.corrected.select_error, 4),
        "floor": round(done.floor, 4),
        "held_out_over_floor": f"{held_out(found):.4f}",
        "declared_values": {k: float(f"{v:.5g}") for k, v in done.refitted.values.items()},
        "values": {k: float(f"{v:.5g}") for k, v in done.corrected.values.items()},
        "rounds": rounds_of(found),
    }
    if poor:
        seen = seen_by(found)
        row["blind_to"] = list(seen.blind)
        row["run_next"] = sorted({name for runs in seen.run_next.values() for name, _ in runs[:1]})
    return row


def diagnosed(parts: Sequence[Case], program: str) -> list[tuple[str, bytes]]:
    """Rows of some cases, made in a worker."""
    known = {case.name: case for case in cases()}
    return [(part.name, _row(known[part.name], program)) for part in parts]


def _row(case: OwnCase, program: str) -> bytes:
    if code_version.__wrapped__() != code_version():
        raise SystemExit("the program has changed under this run: start it again, or from a clone")
    asked = (case.seed, dict(case.effects), case.noise, case.batteries)
    text, truth = make(*asked)
    began = time.process_time()
    with tempfile.TemporaryDirectory() as folder:
        file = write(Path(folder), "recording", text, truth)
        try:
            found = found_in(file, case.removed)
            said = verdict_on(found, case.group == "poor")
            if case.group == "advised":
                runs = advised(found, seen_by(found))
                file = write(Path(folder), "further", *make(*asked, planned(found, runs)))
                before = said["verdict"]
                said = verdict_on(found_in(file), False) | {"before": before, "made": runs}
        except InvalidInput as error:
            said = {"verdict": f"refused: {error.problems[0].what}"}
        except Exception:  # a defect of the program is a row too
            said = {"verdict": "error", "why": traceback.format_exc(limit=-3)}
    row = {
        "case": case.name, "group": case.group, "hides": dict(case.effects), "noise": case.noise,
        "fields": truth["fields"], **said,
    }  # fmt: skip
    row["score"] = score(row)
    row |= {
        "cpu_seconds": round(time.process_time() - began, 1), "commit": program,
        "code": code_version()[:12],
    }  # fmt: skip
    return (json.dumps(row, indent=1) + "\n").encode()


def rows_in(out: Path) -> dict[str, dict[str, Any]]:
    """Rows of this run by case."""
    rows = [json.loads(f.read_text(encoding="utf-8")) for f in (out / "cases").glob("*.json")]
    return {row["case"]: row for row in rows}


def finished(out: Path, only_code: str = "") -> dict[str, Row]:
    """Rows by case, of this run and of the table; what the program failed at is asked again."""
    every = kept(HERE / "diagnose_own.csv") | rows_in(out)
    return {
        case: row
        for case, row in every.items()
        if not row["score"].startswith(("refused", "error"))
        and (not only_code or row["code"] == only_code)
    }


def work(args: argparse.Namespace, wanted: Sequence[OwnCase]) -> None:
    """Diagnose what is not yet there."""
    (args.out / "cases").mkdir(parents=True, exist_ok=True)
    there = finished(args.out, code_version()[:12] if args.fresh else "")
    left = [Case(case.name, ()) for case in wanted if case.name not in there]
    until = time.monotonic() + 3600 * args.hours
    program, done = commit(), [len(there)]

    def take(results: Sequence[tuple[str, bytes]]) -> None:
        for name, content in results:
            write_whole(args.out / "cases" / f"{name}.json", content)
            row = json.loads(content)
            done[0] += 1
            said = " ".join(
                [row["verdict"], *row.get("effects", []), *row.get("depends_on", [])[:2]]
            )
            line = f"{done[0]} {name}: {row['score']} ({said}; {row['cpu_seconds']:.0f} s)"
            print(line, file=sys.stderr, flush=True)

    def submit(executor: Executor, part: Sequence[Case]) -> Future:
        return executor.submit(diagnosed, part, program)

    with Interruption() as interruption:
        stop = lambda: interruption.came or time.monotonic() > until  # noqa: E731
        on_processes(Crew(submit, take, stop, args.jobs), left, 1)


def main() -> None:
    """Run, then make the tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, default=Path("out/diagnose_own"))
    parser.add_argument("--cases", nargs="*", default=["*"], help="patterns of names")
    parser.add_argument("--first", type=int, help="only so many of them")
    parser.add_argument("--hours", type=float, default=1e6, help="begin nothing after so long")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--fresh", action="store_true", help="rows of other programs do not count")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--table", action="store_true")
    args = parser.parse_args()
    wanted = [c for c in cases() if any(fnmatchcase(c.name, p) for p in args.cases)][: args.first]
    if args.list:
        there = finished(args.out)
        for case in wanted:
            print(case.name, there[case.name]["score"] if case.name in there else "-")
        return
    if not args.table:
        if args.jobs > 1:
            os.environ.setdefault("SIMPTER_JOBS", "1")
        work(args, wanted)
    write_tables([*rows_in(args.out).values()], HERE, HERE.parent / "docs")


if __name__ == "__main__":
    main()
