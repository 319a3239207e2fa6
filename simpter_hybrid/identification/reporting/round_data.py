"""A round of a search as plain data: what was tried, on what the residual depends."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ..tracing.further import by_chance
from ..tracing.round import Round
from ..tracing.signature import Dependence

#: Most dependences listed for each balance.
LISTED = 4


def round_data(done: Round, gains: Mapping[str, Any] | None) -> dict[str, Any]:
    """As the JSON has it; `gains`: candidate -> its gain on the runs held out."""
    return {
        "verdict": done.verdict.kind,
        "named": done.verdict.accepted is not None,
        "best": done.best.candidate.name if done.best is not None else None,
        "candidates": [
            {
                "name": t.candidate.name, "family": t.candidate.family, "port": t.candidate.acts_on,
                "select": t.select_error, "gain": t.gain, "share": t.share, "idle": t.idle,
                "by_chance": by_chance(t, done.base),
                "held_out": (gains or {}).get(t.candidate.name),
                "values": {p.name: t.fit.values[p.name] for p in t.candidate.parameters},
                "at_bound": [
                    p.name for p in t.candidate.parameters if p.at_limit(t.fit.values[p.name])
                ],
            }
            for t in done.trials
        ],
        "before": {b: [_dependence(d) for d in v[:LISTED]] for b, v in done.before.items()},
        "after": {b: [_dependence(d) for d in v[:LISTED]] for b, v in done.after.items()},
        "logged": {b: [_dependence(d) for d in v] for b, v in done.logged.items()},
    }  # fmt: skip


def _dependence(d: Dependence) -> dict[str, Any]:
    return {
        "coordinate": d.coordinate, "gain": d.gain, "p_value": d.p_value,
        "centres": d.centres.tolist(), "added": d.added.tolist(), "scaled": d.scaled.tolist(),
        "at": d.at, "half_width": None if d.band is None else d.band.tolist(),
    }  # fmt: skip
