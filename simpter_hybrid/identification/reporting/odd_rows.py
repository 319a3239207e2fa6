"""Rows of a recording that may decide a verdict and should have no part in it."""

from __future__ import annotations

from collections.abc import Sequence

from ..recordings.checks import Finding
from ..recordings.driven_on import DRIVEN_ON
from ..recordings.lone_speeds import LONE

#: Most rows that are listed; the remarks on the recording have all.
LISTED = 3


def odd_rows_sentence(findings: Sequence[Finding]) -> str:
    """Sentence on rows that were driven still, or misread; "" if there are none.

    Parameters
    ----------
    findings : sequence of Finding
        Remarks on a recording.
    """
    driven = [f for f in findings if f.what == DRIVEN_ON]
    lone = [f for f in findings if f.what.endswith(LONE)]
    said = []
    if driven:
        rows = _listed([f"{f.run} for {f.value}" for f in driven])
        said.append(
            f"Was the axis let go only then? It holds its speed at first ({rows}). Rows in which "
            "a motor still drives it may change what is named: cut them (`from` in the map's "
            "[runs], or files of their own) and diagnose again."
        )
    if lone:
        named = ((f.what.removesuffix(LONE).strip(), f) for f in lone)
        rows = _listed([f"{name} {f.value}, {f.run}, t = {f.time:g} s" for name, f in named])
        said.append(
            f"Was a reading dropped or misread ({rows})? A single such row may decide what is "
            "named: mend its cell as the remark on the recording says, and diagnose again."
        )
    return " ".join(said)


def _listed(rows: Sequence[str]) -> str:
    more = f"; and {len(rows) - LISTED} more" if len(rows) > LISTED else ""
    return "; ".join(rows[:LISTED]) + more
