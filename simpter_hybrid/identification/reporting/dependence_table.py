"""Table of what a residual depends on, from `diagnosis_data`'s dictionary."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from ..tracing.locating import BESIDE_RINGING, LEAST_RINGING, P_VALUE, VIBRATION
from ..tracing.ringing import RINGING, line_of
from .tables import number, table

#: Dependences that a page lists.
DEPENDENCES = 12
NOTE = (
    "Curves learned on the runs that fit, tested on those that select; p by surrogates of the "
    "same spectrum, half a per cent at the least.  Of each balance the largest; - is less."
)
#: A line of a spectrum is no part of a mean square.
RINGS = (
    "  What rings is told by its line: how far it stands out of the spectrum after breakaways over "
    "that elsewhere.  It counts where forces depend on nothing, or on what is little of the lack."
)
#: Of a channel that no model reads it is worth knowing that it was asked, and told nothing.
LOGGED = (
    "  Channels that the model does not read are all listed; one of them is what something unknown "
    "depends on only if it tells clearly more than all else."
)


def dependence_table(
    rounds: Sequence[Mapping[str, Any]], straight: bool = False, named: bool = True
) -> str:
    """Table of what the residual depends on, first and with what was found or is best.

    `straight`: of an axis on which forces act, not torques.  `named`: whether the verdict names
    what the rounds went on with.
    """
    if not rounds:
        return "<p>Nothing was looked for.</p>"
    last = rounds[-1]
    went_on = last["named"] or len(rounds) > 1
    left = last["before"] if went_on and not last["named"] else last["after"]
    before, after = (_by_coordinate(one, straight) for one in (rounds[0]["before"], left))
    logged = _by_coordinate(rounds[0].get("logged", {}), straight)
    # They are asked of what a round begins with, and not of what its best candidate leaves.
    beside = _by_coordinate(last.get("logged", {}), straight) if left is last["before"] else {}
    head: tuple[str, ...] = ("residual of, along", "part of its mean square", "p")
    if with_it := _with_what(rounds, named):
        head += (with_it, "p")
    # Each keeps its own few: what the last one depends on may have been hidden in the first.
    shown = (before, after) if with_it else (before,)
    own = [name for name in dict.fromkeys(n for one in shown for n in one) if name not in logged]
    most = sorted(own, key=lambda n: -max(one[n]["gain"] for one in shown if n in one))
    rings, left_ringing = _rings(rounds[0]["before"]), _rings(left)
    rows = [(n, *_part(before.get(n)), *_part(after.get(n))) for n in most[:DEPENDENCES]]
    rows += [
        (f"{name} (logged)", *_part(d), *(_part(beside[name]) if name in beside else ("", "")))
        for name, d in logged.items()
    ]
    if rings or left_ringing:
        name = f"ringing, after breakaways{_beside_forces(rounds[0]['before'])}"
        rows.append((name, *_line(rings), *_line(left_ringing)))
    note = NOTE + (LOGGED if logged else "") + (RINGS if rings or left_ringing else "")
    return f"<p>{note}</p>{table(head, (row[: len(head)] for row in rows))}"


def _with_what(rounds: Sequence[Mapping[str, Any]], named: bool) -> str:
    """Head of the columns on what is left with an effect; "" where none came into question."""
    believed = [one["best"] for one in rounds if one["named"]]
    if believed and named:
        return "with what was found"
    if believed:
        verb = "is" if len(believed) == 1 else "are"
        return f"with {' and '.join(believed)}, which {verb} not named"
    best = rounds[-1]["best"]
    return "" if best is None else f"with {best}, which is not named"


def _by_coordinate(balances: Mapping[str, Sequence[Any]], straight: bool) -> dict[str, Any]:
    called = {"torque": "force"} if straight else {}
    return {
        f"{balance.replace('_', ' ')}, "
        f"{called.get(d['coordinate'], d['coordinate']).replace('_', ' ')}": d
        for balance, found in balances.items()
        if balance != RINGING
        for d in found
    }


def _part(dependence: Mapping[str, float] | None) -> tuple[str, str]:
    """Cells of a dependence: part that its curve takes away where it was tested, and p-value."""
    if dependence is None:
        return "-", "-"
    return f"{max(100 * dependence['gain'], 0.0):.1f} %", number(dependence["p_value"])


def _rings(balances: Mapping[str, Sequence[Any]]) -> Mapping[str, Any] | None:
    """The line that rings, by the rule of what does; the largest of any spectrum is none."""
    found = balances.get(RINGING, ())
    return next(
        (d for d in found if d["gain"] >= LEAST_RINGING and d["p_value"] <= P_VALUE), None
    )  # fmt: skip


def _beside_forces(balances: Mapping[str, Sequence[Any]]) -> str:
    """Words that a line is no finding, where a force shows a coordinate (`before_ringing`)."""
    shown = [
        d for balance, found in balances.items() if balance not in (RINGING, VIBRATION)
        for d in found if d["gain"] >= BESIDE_RINGING and d["p_value"] <= P_VALUE
    ]  # fmt: skip
    return " (no finding beside what forces show)" if shown else ""


def _line(rings: Mapping[str, Any] | None) -> tuple[str, str]:
    """Cells of a line: its frequency and how far it stands out, and p-value."""
    if rings is None:
        return "-", "-"
    frequency, times = line_of(rings["centres"], rings["added"], rings["scaled"])
    return f"{frequency:.0f} Hz, {times:.0f} times the spectrum", number(rings["p_value"])
