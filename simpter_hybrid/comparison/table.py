"""A comparison as a table of text."""

from __future__ import annotations

from ..trajectory import Trajectory
from .compare import Comparison, Row
from .events import changes

HEAD = (
    "final error", "path error", "run time", "found", "missed", "invented", "shift", "drift",
    "created", "Case 7", "steps", "rhs",
)  # fmt: skip


#: A run that tries more steps than this, most of them in vain, chatters: the shipped scenarios try
#: 8,100 at most with bands of 1e-3 and 1e-5, and but for one reject a third of them or less.
CHATTER = 10_000


def number(value: float | None, unit: str = "") -> str:
    """Two digits, or a dash."""
    return "-" if value is None else f"{value:.1e}{unit}"


def cells(row: Row) -> tuple[str, ...]:
    """One line of the table."""
    case_7 = "-"
    if row.case_7:
        case_7 = f"{row.wrong} wrong, {row.absent} absent of {row.case_7}"
    return (
        number(row.final_error), number(row.path_error), f"{row.run_time_error:+.1e}",
        str(row.matched), str(row.missed), str(row.invented), number(row.largest_shift),
        number(row.drift), number(row.energy_created), case_7, str(row.steps),
        str(row.rhs_evaluations),
    )  # fmt: skip


def chatter(run: Trajectory) -> str | None:
    """What a run says that chatters on the edge of its band; None if it does not.

    Its steps are then cut at every catch and release, so that they say nothing of the model's cost
    where it does not.
    """
    steps = run.statistics.get("steps", 0)
    rejected = run.statistics.get("rejected_steps", 0)
    if steps + rejected <= CHATTER or rejected <= steps:
        return None
    return f"chatters on the edge of its band: {rejected} of {steps + rejected} steps were rejected"


def text_of(comparison: Comparison) -> str:
    """The whole table; lengths in m, angles in rad, times in s, energies in J."""
    exact = comparison.reference
    lines = [
        f"{comparison.scenario.name}, exact: {exact.message}; "
        f"{len(changes(exact, exact.t_end))} stops and releases, "
        f"{exact.statistics['steps']} steps"
    ]
    body = [("", *HEAD), *((row.name, *cells(row)) for row in comparison.rows)]
    widths = [max(len(line[k]) for line in body) for k in range(len(HEAD) + 1)]
    for line in body:
        first = line[0].ljust(widths[0])
        rest = (cell.rjust(width) for cell, width in zip(line[1:], widths[1:], strict=True))
        lines.append("  ".join([first, *rest]).rstrip())
    lines += [
        f"{row.name} failed: {row.message}" for row in comparison.rows if row.status == "failed"
    ]
    for row, run in zip(comparison.rows, comparison.runs, strict=True):
        if said := chatter(run):
            lines.append(f"{row.name} {said}")
    return "\n".join(lines) + "\n"
