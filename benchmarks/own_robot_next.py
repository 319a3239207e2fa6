"""Does the experiment that a diagnosis asks for tell apart what it could not? Own robot files.

    python benchmarks/own_robot_next.py      # goes on where it was; own_robot_next.csv

A file is diagnosed; to its eight runs are added the recommended experiment, twice (once fitted,
once selecting), made by the own generator with its own hand; and, for comparison, as many further
runs of the usual kind.  Both are diagnosed again.
"""

from __future__ import annotations

import csv
import sys
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from own_robot_files import RUNS, right_names, write
from own_robot_rig import DURATION, TICK
from program import commit

from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.identifiability_report import Sight, sight
from simpter_hybrid.identification.maps import MAPS, find_model
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.identification.result import Diagnosis
from simpter_hybrid.identification.tip.experiments import tip_experiments
from simpter_hybrid.identification.tip.plan import tip_reach
from simpter_hybrid.identification.tracing.verdict import Verdict

TABLE = Path(__file__).parent / "own_robot_next.csv"
COLUMNS = (
    "kind", "seed", "size", "noise", "right", "first", "asked", "experiment", "expected", "needed",
    "usual", "recommended", "apart_first", "apart_usual", "apart_recommended",
    "commit",
)  # fmt: skip
#: (kind, seed, size, coloured, what is asked if the verdict names one effect only): what the table
#: of own robot files leaves open, but for an offset of the force: no run tells it from a tilt.
CASES: tuple[tuple[str, int, float, bool, tuple[str, str]], ...] = (
    ("bias", 218, 1.0, True, ("bias-force", "tilt")),
    ("log_speed_one", 241, 1.0, False, ("logarithmic-speed", "command-scale")),
    ("command_one", 257, 1.0, False, ("command-scale", "logarithmic-speed")),
)
#: Terms of the cosine series by which the generator's hand follows a path.
TERMS = 72
INCH = 0.0254


def generated(found: Diagnosis, experiment: str) -> list[tuple]:
    """Plans of the own generator for an experiment, twice."""
    declared = load(find_model("robot"))
    reach = tip_reach(declared, found.split.fit)
    plans = [p for p in tip_experiments(reach) if p.experiment == experiment]
    a, d = declared.device.l_a / INCH, declared.device.l_d / INCH
    ticks = np.arange(int(DURATION * TICK) + 1) / TICK
    made = []
    for plan in [*plans, *plans]:
        q1, q2 = plan.pose
        tip = np.array([a * np.cos(q1) - d * np.sin(q2), a * np.sin(q1) + d * np.cos(q2)])
        w = np.pi * np.arange(1, TERMS + 1) / DURATION
        waves = np.cos(np.outer(reach.time, w)) - 1.0
        path = np.empty((2, TERMS, 2))
        path[:, :, 0] = np.linalg.lstsq(waves, (tip - tip[:, :1]).T, rcond=None)[0].T
        path[:, :, 1] = w / (2 * np.pi)
        rows = np.minimum(np.round(ticks / reach.step).astype(int), reach.time.size - 1)
        table = np.round(plan.commands[:, rows].T, 3)
        made.append((plan.pose[:, 0].copy(), table, path, np.full((2, TERMS), 0.5 * np.pi)))
    return made


def diagnosed(folder: Path, case, further: Sequence[tuple] | int = ()) -> Diagnosis:
    """A file with further runs, the first half of which are fitted and the others select."""
    kind, seed, size, coloured, _ = case
    file = write(folder, kind, seed, size, coloured, further)
    count = further if isinstance(further, int) else len(further)
    text = (MAPS / "robot.toml").read_text(encoding="utf-8")
    for last, first in ((4, RUNS), (6, RUNS + count // 2)):
        more = "".join(f', "run {first + k + 1}"' for k in range(count // 2))
        text = text.replace(f'"run {last}"]', f'"run {last}"{more}]', 1)
    described = folder / "map.toml"
    described.write_text(text, encoding="utf-8")
    return diagnose(load_recording(file, described), load(find_model("robot")))


def doubted(found: Diagnosis) -> tuple[str, str] | None:
    """What was named, and the first effect that is not excluded in its place."""
    verdict = found.search.verdict
    if verdict.accepted is None or not verdict.rivals:
        return None
    one, other = verdict.accepted.candidate, verdict.rivals[0].candidate
    return one.listed_as, other.listed_as


def asked(found: Diagnosis, pair: tuple[str, str]) -> Sight:
    """What a diagnosis says of two effects (`seen_by` for these alone)."""
    few = tuple(c for name in pair for c in found.candidates if c.name == name)
    one, other = (
        next(t for t in found.search.rounds[0].trials if t.candidate.listed_as == name)
        for name in pair
    )
    question = Verdict("cannot be told apart", one, (other,))
    done = found.search
    planned = found.experiments(done.refitted.values, found.split.select)
    unit = min(1.0, done.floor)
    return sight(done.refitted, few, found.split.select, planned, [question], unit)


def said(found: Diagnosis) -> str:
    """Verdict in one cell."""
    verdict = found.search.verdict
    names = " and ".join(e.name for e in found.search.corrected.effects)
    others = [t.candidate.name for t in verdict.rivals] if verdict.accepted else []
    return f"{verdict.kind}: {names}" + (f" or {', '.join(others)}" if others else "")


def apart(found: Diagnosis, pair: tuple[str, str]) -> str:
    """Error of the worse over that of the better of two effects on the selecting runs."""
    errors = {}
    for t in found.search.rounds[0].trials:
        name = t.candidate.listed_as
        errors[name] = min(t.select_error, errors.get(name, np.inf))
    if not all(name in errors for name in pair):
        return "not fitted"
    a, b = (errors[name] for name in pair)
    return f"{max(a, b) / min(a, b):.3f}"


def row(case) -> dict[str, str]:
    """One case."""
    kind, seed, size, coloured, pair = case
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        first = diagnosed(folder, case)
        pair = doubted(first) or pair
        print(f"{said(first)}; {apart(first, pair)}", file=sys.stderr, flush=True)
        seen = asked(first, pair)
        experiment, expected = seen.run_next[pair][0]
        print(f"{pair}: {seen.run_next[pair]}", file=sys.stderr, flush=True)
        after = diagnosed(folder, case, generated(first, experiment))
        print(f"{said(after)}; {apart(after, pair)}", file=sys.stderr, flush=True)
        usual = diagnosed(folder, case, len(generated(first, experiment)))
    return {
        "kind": kind, "seed": str(seed), "size": f"{size:g}",
        "noise": "coloured" if coloured else "white", "right": " ".join(right_names(kind)),
        "first": said(first), "asked": " or ".join(pair), "experiment": experiment,
        "expected": f"{expected:.0f}", "needed": f"{seen.needed[experiment]:.0f}",
        "usual": said(usual), "recommended": said(after), "apart_first": apart(first, pair),
        "apart_usual": apart(usual, pair), "apart_recommended": apart(after, pair),
        "commit": commit(),
    }  # fmt: skip


def main() -> None:
    """Go through the cases that the table does not have."""
    if not TABLE.exists():
        TABLE.write_text(",".join(COLUMNS) + "\n", encoding="utf-8")
    with TABLE.open(encoding="utf-8", newline="") as handle:
        have = {(r["kind"], r["seed"], r["size"]) for r in csv.DictReader(handle)}
    for case in CASES:
        if (case[0], str(case[1]), f"{case[2]:g}") in have:
            continue
        began = time.process_time()
        made = row(case)
        with TABLE.open("a", encoding="utf-8", newline="") as handle:
            csv.DictWriter(handle, COLUMNS, lineterminator="\n").writerow(made)
        spent = f"{time.process_time() - began:.0f} s CPU"
        print(f"{case[0]}: {made['first']} -> {made['recommended']} ({spent})", file=sys.stderr)


if __name__ == "__main__":
    main()
