"""Tables, confusion matrix and page from the rows that `diagnose_own.py` has made."""

from __future__ import annotations

import csv
import io
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from own_cases import cases
from own_page import page
from own_score import CONTESTED, NAMED, Row, ratio, short, size
from own_testbed_effects import KINDS

from simpter_hybrid.identification.tracing.verdict import LACKING

COLUMNS = (
    "case", "group", "noise", "verdict", "effects", "cannot_exclude", "depends_on", "blind_to",
    "refitted", "after", "floor", "after_over_floor", "held_out_over_floor", "size_error", "score",
    "first_score", "cpu_seconds", "commit", "code",
)  # fmt: skip
OTHER = ("nothing missing", *LACKING, CONTESTED)


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
            for name in ("effects", "cannot_exclude", "depends_on", "blind_to"):
                # A sensor's error has a name of two words.
                row[name] = (line.get(name) or "").replace("sensor ", "sensor\0").split()
                row[name] = [word.replace("\0", " ") for word in row[name]]
            for name in ("refitted", "after", "floor", "size_error", "cpu_seconds"):
                if name in row:
                    row[name] = float(row[name])
            if line["case"] in known:
                found[line["case"]] = row | {"hides": dict(known[line["case"]].effects)}
    return found


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
    axes.set_title("Synthetic recordings: what is hidden in one, and what is said", fontsize=9)
    figure.savefig(file, dpi=130, metadata={"Software": None})
