"""Whether the runs test a model at all: of what no model could get wrong nothing is cleared."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from .axis.window_length import UNTESTED
from .recordings.checks import Finding
from .tracing.rounds import SearchResult


def untested(remarks: Sequence[Finding]) -> Finding | None:
    """The remark that the positions say next to nothing of the forces; None without one."""
    return next((one for one in remarks if one.what.startswith(UNTESTED)), None)


def not_cleared(done: SearchResult, remarks: Sequence[Finding]) -> SearchResult:
    """The diagnosis whose all-clear is none where the runs test no model."""
    if done.verdict.kind != "nothing missing" or untested(remarks) is None:
        return done
    return replace(done, verdict=replace(done.verdict, kind="lack or noise"))
