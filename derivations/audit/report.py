"""The audit as a table: one row for each equation (1)-(77), then counts, tables and statements."""

from __future__ import annotations

from collections import Counter
from functools import cache
from pathlib import Path

from derivations.audit import (
    calibration,
    clutch_forces,
    clutch_maps,
    counts,
    dynamics,
    electromagnet,
    kinematics,
    measures,
    special_cases,
    statements,
    static_torques,
)
from derivations.audit.verdict import LOSSES, Entry, assess

PATH = Path(__file__).resolve().parent.parent / "AUDIT.md"
SUBJECTS = (
    kinematics, dynamics, special_cases, electromagnet, calibration, clutch_maps, measures,
    clutch_forces, static_torques, counts, statements,
)  # fmt: skip

INTRODUCTION = """\
# Audit of the thesis's equations

Written by `python -m derivations --audit`. The thesis is at hand as a transcript without figures
that has lost marks. For every item up to four readings are checked, in this order, and the first
that holds gives the verdict:

1. the transcript as it stands: **agrees**;
2. with marks put back of a kind that the transcript demonstrably loses: **transcript damaged**
   (the thesis itself agrees);
3. that reading under a condition that the thesis does not state there: **agrees under a stated
   condition**;
4. another formula, the one that follows from the derivation: **misprinted**, or, for a sentence
   against a figure, a table or the derivation, **contradicted**.

Flattened layout (raised exponents, fraction bars, matrix brackets) is read back everywhere and not
counted as a loss. The transcript never adds a mark or turns one into another, and it keeps the bars
of absolute values; so a sign that it shows wrong is taken for the thesis's.

Notation: th' for a rate, C the clutch map (rows (1,0), (0,1), (1,-1), (1,1)), M and V as in (21).
Torques in lb-in. Lengths of the linkage are inferred, not printed (`pter_parameters.toml`).
"""

KINDS_OF_LOSS = "What the transcript loses, and where that is certain from the words beside it:"


@cache
def all_entries() -> tuple[Entry, ...]:
    """Every audited item in the order of the report: equations by number, then the rest."""
    found = [entry for subject in SUBJECTS for entry in subject.entries()]
    equations = [entry for entry in found if entry.number.isdigit()]
    others = [entry for entry in found if not entry.number.isdigit()]
    return (*sorted(equations, key=lambda entry: int(entry.number)), *others)


def _cell(text: str) -> str:
    return text.replace("|", "\\|")


def _row(entry: Entry) -> str:
    notes = []
    if entry.condition:
        notes.append(f"condition: {entry.condition}")
    if entry.corrected:
        notes.append(f"correct: {entry.corrected}")
    if entry.remark:
        notes.append(entry.remark)
    cells = (
        entry.number, entry.what, f"**{assess(entry).verdict}**", "; ".join(notes), entry.lost,
        entry.how,
    )  # fmt: skip
    return "| " + " | ".join(_cell(cell) for cell in cells) + " |"


def _table(title: str, heading: str, entries: list[Entry]) -> list[str]:
    tally = Counter(assess(entry).verdict for entry in entries)
    summary = ", ".join(f"{count} {verdict}" for verdict, count in sorted(tally.items()))
    return [
        f"## {title}",
        "",
        f"{len(entries)} items: {summary}.",
        "",
        f"| {heading} | What | Verdict | Condition, correct form, remark | Lost | How checked |",
        "|---|---|---|---|---|---|",
        *(_row(entry) for entry in entries),
        "",
    ]


def text() -> str:
    """The report as Markdown; the same sources give the same bytes."""
    entries = all_entries()
    equations = [entry for entry in entries if entry.number.isdigit()]
    others = [entry for entry in entries if not entry.number.isdigit()]
    losses = [f"* {kind}: {where}" for kind, where in LOSSES.items()]
    lines = [
        INTRODUCTION,
        KINDS_OF_LOSS,
        "",
        *losses,
        "",
        *_table("Equations (1)-(77)", "No.", equations),
        *_table("Counts, tables and statements", "Where", others),
    ]
    return "\n".join(lines).rstrip() + "\n"


def write() -> str:
    """Write ``derivations/AUDIT.md`` and return its text."""
    report = text()
    PATH.write_text(report, encoding="utf-8", newline="\n")
    return report
