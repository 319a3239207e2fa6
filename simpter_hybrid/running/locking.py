"""Locks that contradict each other: stuck clutches that the pose does not allow together."""

from __future__ import annotations

from typing import Any

from ..kernel.instant import slip_of
from ..kernel.rules import contradicting
from .failures import incompatible


def contradiction(md: Any, w: Any, y: list[float]) -> str:
    """Why the present stuck set cannot be, or '' if it can.

    Parameters
    ----------
    md, w : Model, Work
        In the present mode.
    y : list of float
        State that satisfies the independent clutches.
    """
    which = contradicting(md, w, y)
    if which < 0:
        return ""
    others = ", ".join(str(k + 1) for k in sorted(w.rows[: w.meta[0]]))
    return incompatible(
        which, f"clutches {others}", f" at {slip_of(w.C, y, md.n, which):.3g} rad/s"
    )
