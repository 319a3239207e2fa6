"""Verdicts on rigs of one coordinate that nobody wrote code for: rows, scores, tables."""

from __future__ import annotations

import argparse
import csv
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from functools import partial
from itertools import product
from pathlib import Path

from program import commit

from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.identification.reporting.sentences import forms_of
from simpter_hybrid.identification.tracing.verdict import LACKING

#: Times the floor up to which an error after counts as near it.
NEAR = 1.06
COLUMNS = (
    "kind", "sensor", "seed", "verdict", "named", "or_form", "not_excluded", "depends_on",
    "before_over_floor", "after_over_floor", "score", "commit",
)  # fmt: skip
Rows = list[dict[str, str]]
#: What is hidden and in nobody's list -> on which an unknown has to depend.
SHOWS = {"ages": "displacement_since_reversal", "catch": "position"}
#: Score of an unknown that names other variables.
ELSEWHERE = "unknown, elsewhere"
#: Kind -> what is hidden, and which names are right.
Kinds = Mapping[str, tuple[Mapping[str, float], tuple[str, ...]]]

#: Folder, kind, sensor, seed -> recording, model and map.
Write = Callable[[Path, str, str, int], tuple[Path, Path, Path]]


def written(
    folder: Path, name: str, rows: Sequence[str], model: str,
    tolerated: Mapping[str, tuple[str, float]], described: str,
) -> tuple[Path, Path, Path]:  # fmt: skip
    """Recording, model with its tolerances, and map; labelled synthetic by their names."""
    known = "".join(
        f'[[tolerances]]\nname = "{tolerance}"\nparameters = ["{key}"]\nrelative = {size}\n'
        for tolerance, (key, size) in tolerated.items()
    )
    texts = {".csv": "\n".join(rows) + "\n", ".toml": model + known, "_map.toml": described}
    for end, text in texts.items():
        (folder / f"synthetic_{name}{end}").write_text(text, encoding="utf-8")
    return tuple(folder / f"synthetic_{name}{end}" for end in texts)  # type: ignore[return-value]


def row_of(write: Write, program: str, kind: str, sensor: str, seed: int) -> dict[str, str]:
    """The verdict of a program on one file, which is thrown away."""
    with tempfile.TemporaryDirectory() as folder:
        said = said_of(*write(Path(folder), kind, sensor, seed))
    return said | {"kind": kind, "sensor": sensor, "seed": str(seed), "commit": program}


def go_through(
    write: Write, table: Path, about: str, kinds: Kinds, sensors: Collection[str], seeds: int,
    unseen: Collection[tuple[str, str]] = (),
) -> None:  # fmt: skip
    """The command of such a rig: go through what is not yet in its table, and write its page.

    Kinds that a sensor does not see are `unseen`.
    """
    parser = argparse.ArgumentParser(description=sys.modules["__main__"].__doc__)
    parser.add_argument("--seeds", type=int, default=seeds)
    parser.add_argument("--sensors", nargs="*", default=list(sensors))
    parser.add_argument("--fresh", action="store_true", help="make rows of other programs anew")
    args, program = parser.parse_args(), commit()
    every = product(range(1, args.seeds + 1), kinds, args.sensors)
    cases = ((kind, sensor, seed) for seed, kind, sensor in every if (kind, sensor) not in unseen)
    made, scored = partial(row_of, write, program), partial(score, kinds=kinds)
    rows = gone_through(table, cases, made, scored, program if args.fresh else "")
    lines = [about, *counted(rows, sensors), "", errors_left(rows), ""]
    text = "\n".join([*lines, *by_kind(rows, kinds, sensors)]) + "\n"
    table.with_suffix(".md").write_text(text, encoding="utf-8")


def said_of(file: Path, model: Path, map_file: Path) -> dict[str, str]:
    """The verdict on one recording."""
    found = diagnose(load_recording(file, map_file), load(str(model)))
    done = found.search
    return {
        "verdict": done.verdict.kind,
        "named": " ".join(e.name for e in done.corrected.effects),
        "or_form": " ".join(f for e in done.corrected.effects for f in forms_of(found, e.name)),
        "not_excluded": " ".join(t.candidate.name for t in done.verdict.rivals if t),
        "depends_on": " ".join(done.verdict.coordinates),
        "before_over_floor": f"{done.refitted.select_error / done.floor:.3f}",
        "after_over_floor": f"{done.corrected.select_error / done.floor:.3f}",
    }


def gone_through(
    table: Path,
    cases: Iterable[tuple[str, str, int]],
    made: Callable[[str, str, int], dict[str, str]],
    scored: Callable[[dict[str, str]], str],
    kept: str = "",
) -> Rows:
    """All rows of a table, scored anew, with those of cases that it does not have yet.

    If `kept` names a program, the cases' rows of others are made anew, and stand until then.
    """
    rows: dict[tuple[str, str, str], dict[str, str]] = {}
    if table.exists():
        with table.open(encoding="utf-8", newline="") as handle:
            read = [r | {"score": scored(r)} for r in csv.DictReader(handle)]
        rows = {(r["kind"], r["sensor"], r["seed"]): r for r in read}
        _write(table, read)
    for kind, sensor, seed in cases:
        case = kind, sensor, str(seed)
        if case in rows and kept in ("", rows[case]["commit"]):
            continue
        cpu = time.process_time()
        row = made(kind, sensor, seed)
        rows[case] = row | {"score": scored(row)}
        _write(table, list(rows.values()))
        told = " ".join(rows[case][c] for c in COLUMNS)
        print(f"{told} ({time.process_time() - cpu:.0f} s CPU)", file=sys.stderr, flush=True)
    return list(rows.values())


def _write(table: Path, rows: Rows) -> None:
    with table.open("w", encoding="utf-8", newline="") as handle:
        writer = csv.DictWriter(handle, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def score(said: dict[str, str], kinds: Kinds, sensor: Collection[str] = ()) -> str:
    """``right``, ``set with it``, ``misnamed``, ``spurious``, ``unknown``, `ELSEWHERE`, ``missed``.

    By what was hidden, less what is of the `sensor`.  What is in nobody's list is unknown, and
    found where the variable is named of which it is a matter.
    """
    right, named = kinds[said["kind"]][1], said["named"].split()
    if said["verdict"] in ("nothing missing", *LACKING):
        hidden = {*kinds[said["kind"]][0]} - {*sensor}
        expected = "unknown" if not right and hidden else "nothing missing"
        if not right:
            depends = {d.rpartition(":")[2] for d in said["depends_on"].split()}
            where = {SHOWS[name] for name in hidden if name in SHOWS}
            if said["verdict"] == expected == "unknown" and not where <= depends:
                return ELSEWHERE
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


def counted(rows: Rows, sensors: Iterable[str]) -> list[str]:
    """How often what was said of all kinds, a row for each sensor."""
    scores = [s for s, _ in Counter(r["score"] for r in rows).most_common()]
    lines = [
        "| logged | recordings | " + " | ".join(scores) + " |",
        "|" + " --- |" * (2 + len(scores)),
    ]
    for sensor in sensors:
        tally = Counter(r["score"] for r in rows if r["sensor"] == sensor)
        cells = " | ".join(str(tally[s] or "") for s in scores)
        lines.append(f"| {sensor} | {tally.total()} | {cells} |")
    programs = ", ".join(f"{n} by {c}" for c, n in Counter(r["commit"] for r in rows).most_common())
    return [*lines, "", f"Rows by program: {programs}."]


def errors_left(rows: Rows) -> str:
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


def by_kind(
    rows: Rows,
    kinds: Iterable[str],
    sensors: Collection[str],
    logs: Callable[[str, str], bool] = lambda sensor, kind: True,
) -> list[str]:
    """Scores and errors after, a row for each kind."""
    lines = header("hidden", *sensors)
    for kind in kinds:
        cells = []
        for sensor in sensors:
            of = [r for r in rows if r["kind"] == kind and r["sensor"] == sensor]
            if not of or not logs(sensor, kind):
                cells.append("")
                continue
            tally = Counter(r["score"] for r in of)
            ratios = [r["after_over_floor"] for r in of]
            cells.append(
                "; ".join(f"{n} {s}" for s, n in tally.items()) + f" ({', '.join(ratios)})"
            )
        lines.append(f"| {kind} | " + " | ".join(cells) + " |")
    return lines
