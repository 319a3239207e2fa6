"""Tables, confusion matrix and page from the rows that `diagnose_own.py` has made."""

from __future__ import annotations

import csv
import io
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path
from statistics import median
from typing import Any

from own_cases import COMMONEST, NOISES, STRENGTHS, WEAKER, cases
from own_score import CONTESTED, NAMED, short, size_error
from own_testbed_effects import KINDS

from simpter_hybrid.identification.tracing.verdict import LACKING

Row = Mapping[str, Any]
COLUMNS = (
    "case", "group", "noise", "verdict", "effects", "cannot_exclude", "depends_on", "refitted",
    "after", "floor", "after_over_floor", "held_out_over_floor", "size_error", "score",
    "first_score", "cpu_seconds", "commit", "code",
)  # fmt: skip
SCORES = (
    "right", "set with it", "part", "unknown", "missed", "misnamed", "spurious", "set without it",
    "named", "set named",
)  # fmt: skip
OTHER = ("nothing missing", *LACKING, CONTESTED)
EVERY = (*STRENGTHS, *WEAKER)


def write_tables(rows: Sequence[Row], benchmarks: Path, docs: Path) -> None:
    """The table, the confusion matrix as table and picture, and the page.

    Lines of the table for which there is no row are kept: the files of a run may be gone.  What was
    said of a case when it was unseen stays in ``first_score``.
    """
    order = {case.name: k for k, case in enumerate(cases())}
    before = kept(benchmarks / "diagnose_own.csv")
    every = before | {r["case"]: r for r in rows}
    for name, row in every.items():
        unseen = before.get(name, row).get("first_score") or row["score"]
        every[name] = {**row, "first_score": unseen}
    rows = sorted((r for c, r in every.items() if c in order), key=lambda r: order[r["case"]])
    (benchmarks / "diagnose_own.csv").write_text(table(rows), encoding="utf-8")
    truths, said, counts = confusion(rows)
    text = _csv([["hides", *said], *[[t, *c] for t, c in zip(truths, counts, strict=True)]])
    (benchmarks / "diagnose_own_confusion.csv").write_text(text, encoding="utf-8")
    if truths:
        picture(truths, said, counts, docs / "own-generator.png")
    (docs / "own-generator.md").write_text(page(rows, (truths, said, counts)), encoding="utf-8")


def kept(file: Path) -> dict[str, Row]:
    """Rows as far as a table tells of them."""
    if not file.exists():
        return {}
    known, found = {case.name: case for case in cases()}, {}
    with file.open(encoding="utf-8", newline="") as handle:
        for line in csv.DictReader(handle):
            row: dict[str, Any] = {k: v for k, v in line.items() if v != ""}
            for name in ("effects", "cannot_exclude", "depends_on"):
                # A sensor's error has a name of two words.
                row[name] = line[name].replace("sensor ", "sensor\0").split()
                row[name] = [word.replace("\0", " ") for word in row[name]]
            for name in ("refitted", "after", "floor", "size_error", "cpu_seconds"):
                if name in row:
                    row[name] = float(row[name])
            if line["case"] in known:
                found[line["case"]] = row | {"hides": dict(known[line["case"]].effects)}
    return found


def size(row: Row) -> float | None:
    """Relative error of the size, where it can be told."""
    return size_error(row) if "values" in row else row.get("size_error")


def ratio(row: Row) -> float | None:
    """Error after over the floor."""
    return row["after"] / row["floor"] if "after" in row else None


def table(rows: Sequence[Row]) -> str:
    """One line a case."""
    lines: list[list[object]] = [list(COLUMNS)]
    for row in rows:
        plain = {k: row.get(k, "") for k in COLUMNS}
        flat = {k: " ".join(v) if isinstance(v, list) else v for k, v in plain.items()}
        over, off = ratio(row), size(row)
        flat["after_over_floor"] = "" if over is None else f"{over:.4f}"
        flat["size_error"] = "" if off is None else f"{off:.3f}"
        lines.append([flat[column] for column in COLUMNS])
    return _csv(lines)


def _csv(lines: Sequence[Sequence[object]]) -> str:
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerows(lines)
    return out.getvalue()


def confusion(rows: Sequence[Row]) -> tuple[list[str], list[str], list[list[int]]]:
    """What single recordings hide against the first effect named, or what else was said."""
    single = [r for r in rows if r["group"] in ("null", "single", "outside")]
    pairs = Counter()
    for row in single:
        truth = next(iter(row["hides"]), "nothing")
        word = short(row)
        pairs[truth, row["effects"][0] if row["verdict"] in NAMED else word] += 1
    truths = [t for t in ("nothing", *KINDS) if any(t == a for a, _ in pairs)]
    heard = {b for _, b in pairs}
    first = [name for kind in KINDS.values() for name in kind.names]
    said = [s for s in dict.fromkeys([*first, *sorted(heard)]) if s in heard and s not in OTHER]
    said += [s for s in OTHER if s in heard]
    return truths, said, [[pairs[t, s] for s in said] for t in truths]


def picture(truths: list[str], said: list[str], counts: list[list[int]], file: Path) -> None:
    """The confusion matrix; shares of each line, right ones framed."""
    from matplotlib.figure import Figure
    from matplotlib.patches import Rectangle

    figure = Figure(
        figsize=(2.2 + 0.36 * len(said), 2.2 + 0.27 * len(truths)), layout="constrained"
    )
    axes = figure.subplots()
    shares = [[c / max(1, sum(line)) for c in line] for line in counts]
    axes.imshow(shares, cmap="Blues", vmin=0.0, vmax=1.0, aspect="auto")
    for i, line in enumerate(counts):
        for j, count in enumerate(line):
            if count:
                colour = "white" if shares[i][j] > 0.6 else "black"
                axes.text(j, i, str(count), ha="center", va="center", fontsize=7, color=colour)
            kind = KINDS.get(truths[i])
            right = kind.names if kind and kind.names else (OTHER[1 if kind else 0],)
            if said[j] in right:
                box = Rectangle(
                    (j - 0.5, i - 0.5), 1, 1, fill=False, edgecolor="tab:orange", lw=1.5
                )
                axes.add_patch(box)
    axes.set_xticks(range(len(said)), said, rotation=60, ha="right", fontsize=7)
    axes.set_yticks(range(len(truths)), truths, fontsize=7)
    axes.set_xlabel("said")
    axes.set_ylabel("hidden")
    figure.savefig(file, dpi=130, metadata={"Software": None})


def summary(rows: Sequence[Row]) -> list[list[object]]:
    """One line a group, strength and noise: how many of each score."""
    lines = []
    for group in ("null", "single", "pair", "outside", "without", "poor", "advised"):
        for strength in EVERY:
            for noise in NOISES:
                of = [
                    r for r in rows
                    if r["group"] == group and r["noise"] == noise
                    and max(r["hides"].values(), default=1.0) == strength
                ]  # fmt: skip
                if of:
                    tally = Counter(r["score"] for r in of)
                    named = "-" if group == "null" else f"{strength:g}"
                    lines.append([group, named, noise, len(of), *(tally[s] or "" for s in SCORES)])
    return lines


def changed(rows: Sequence[Row]) -> list[list[object]]:
    """Cases on which another verdict was scored when they were first run."""
    return [
        [r["group"], f"{max(r['hides'].values(), default=1.0):g}", r["case"], r["first_score"],
         r["score"]]
        for r in rows
        if r["first_score"] != r["score"]
    ]  # fmt: skip


def by_effect(rows: Sequence[Row]) -> list[list[object]]:
    """Right of all, at each strength."""
    lines, rich = [], [r for r in rows if r["group"] in ("single", "pair", "outside")]
    for name, kind in KINDS.items():
        if not any(name in r["hides"] for r in rich):
            continue
        line: list[object] = [name]
        for strength in STRENGTHS:
            of = [r for r in rich if r["hides"] == {name: strength}]
            right = sum(r["score"] == "right" for r in of)
            wrong = sum(r["score"] in ("misnamed", "spurious", "named") for r in of)
            line.append(
                f"{right} of {len(of)}" + (f", {wrong} wrong" if wrong else "") if of else ""
            )
        over = [ratio(r) for r in rich if name in r["hides"] and r["score"] == "right"]
        sizes = [size(r) for r in rich if r["hides"].keys() == {name} and r["score"] == "right"]
        measured = [s for s in sizes if s is not None]
        line.append(f"{median(over):.3f}" if over and kind.names else "")
        line.append(f"{100 * median(measured):.0f} %" if measured else "")
        lines.append(line)
    return lines


def limits(rows: Sequence[Row]) -> list[list[object]]:
    """How weak the commonest effects may be: the error over the floor, and what was said."""
    lines = []
    for name in COMMONEST:
        line: list[object] = [name]
        for strength in EVERY:
            of = [r for r in rows if r["group"] == "single" and r["hides"] == {name: strength}]
            shown = [f"{r['refitted'] / r['floor']:.3f} {r['score']}" for r in of if "floor" in r]
            line.append("; ".join(shown))
        if any(line[-len(WEAKER) :]):
            lines.append(line)
    return lines


def _markdown(head: Sequence[object], lines: Sequence[Sequence[object]]) -> str:
    return "\n".join(
        "| " + " | ".join(str(x) for x in line) + " |"
        for line in [head, ["---"] * len(head), *lines]
    )


def page(rows: Sequence[Row], matrix: tuple[list[str], list[str], list[list[int]]]) -> str:
    """docs/own-generator.md."""
    truths, said, counts = matrix
    nulls = [r for r in rows if r["group"] == "null"]
    named = sum(r["score"] == "named" for r in nulls)
    right = [r for r in rows if r["group"] == "single" and r["score"] == "right"]
    over = [x for x in map(ratio, right) if x is not None]
    unsaid = sum(ratio(r) > 1.05 for r in rows if r["verdict"] == "effect")  # type: ignore[operator]
    cpu = [r["cpu_seconds"] for r in rows]
    programs = Counter(r["commit"] for r in rows)
    facts = [
        f"{len(rows)} of {len(cases())} cases are done, by the program at "
        + ", ".join(f"{c} ({n})" for c, n in programs.items()) + ".",
        f"Nulls named: {named} of {len(nulls)}.",
    ]  # fmt: skip
    if over:
        close = sum(x <= 1.03 for x in over)
        facts.append(
            f"Error after over the floor, where the name is right: median {median(over):.3f}, "
            f"at most 1.03 in {close} of {len(over)}; above 1.05 without a word in {unsaid}."
        )
    if cpu:
        facts.append(f"CPU time a diagnosis: median {median(cpu):.0f} s, most {max(cpu):.0f} s.")
    matrix_text = _markdown(
        ["hidden", *said],
        [[t, *(c or "" for c in line)] for t, line in zip(truths, counts, strict=True)],
    )
    return "\n".join([
        ABOUT, *[f"- {fact}" for fact in facts], "", "## By group", "",
        _markdown(["group", "strength", "noise", "cases", *SCORES], summary(rows)), "",
        FIRST, "", _markdown(["group", "strength", "case", "at first", "now"], changed(rows)), "",
        "## By effect", "", _markdown(
            ["hidden", "strength 1", "0.6", "0.35", "after/floor", "error of size"],
            by_effect(rows)), "",
        SIZES,
        *_limits_text(rows), "", "## What was said of what", "", matrix_text, "",
        "![confusion](own-generator.png)", "",
    ])  # fmt: skip


def _limits_text(rows: Sequence[Row]) -> list[str]:
    lines = limits(rows)
    if not lines:
        return []
    head = ["hidden", *(f"{strength:g}" for strength in EVERY)]
    return ["", "## How weak an effect may be", "", LIMITS, "", _markdown(head, lines)]


LIMITS = """Error over the floor after the declared parameters were refitted, which is all that a
recording shows of what is hidden, and whether the verdict is right; one entry a recording."""


SIZES = """Right of an effect in nobody's list: unknown, with a coordinate that belongs to it.
Errors of size are those of numbers of the same name: an own drag grows with the 1.1th power of
speed (at 2 rad/s 7 % more than in proportion), an own Stribeck fades with an exponent of 1.3, an
own slow release depends on the excitation."""

FIRST = """Counts above are of the latest run of each case.  Unseen is a case when it is first run;
where rules were changed since and it was run again with another score, both stand here (a rule may
have been made on it)."""

ABOUT = """# Recordings of another generator

    python benchmarks/diagnose_own.py --hours 4
    python benchmarks/own_testbed.py DIR --seed 1 --effects stribeck=1 imbalance=0.6

`benchmarks/own_testbed*.py` makes recordings of the testbed with the plan of the practice files
and shares no code with the package: steps of 50 us, a rule for stick of its own, and forms that are
not those of the library (an exponent of 1.3 for Stribeck, two time constants of heat, five plays,
harmonics beyond the second, a soft limit of the supply). Seven effects are in nobody's list. At
strength 1 the residual after the refit is 1.1 to 3 times the floor, as in the practice files; half
of the recordings have coloured noise (60 % of its variance with a correlation time of 20 ms).
`without`: recordings of strength 1, diagnosed with every right name taken out of the library; right
is "unknown". `poor`: one-way runs, the motor's torque not logged. `advised`: the same rig with the
runs made that the diagnosis of the poor recording puts first, both torques logged in them.
Each case has its seed from its name; the list is ordered so that any beginning of it is a fair
part. This page is written by the command.
"""
