"""What may be said of a whole search, round after round."""

from __future__ import annotations

from collections.abc import Sequence

from ..fitting.fitted_model import Trial
from .limits import IMPERFECT, REPEATED, Limits
from .verdict import LACKING, LEAST_SHARE_IF_FOREIGN, Verdict


def conclude(
    rounds: Sequence[Verdict],
    total_share: float,
    ratio: float,
    where: Sequence[str] = (),
    limit: Limits = REPEATED,
) -> Verdict:
    """The verdict on a whole search.

    A first round that is open names nothing unless the effects after it account for what it left:
    the last of them leaves nothing foreign itself (slow effects together imitate a slow one that is
    not in the library, each of them open), and with all of them little is left.
    Nor is anything named where what came last is open, leaves a lack and, with all before, much of
    it: patches.

    Parameters
    ----------
    rounds : sequence of Verdict
        Of each round, in order.
    total_share : float
        Part of the lack that all accepted effects explain together.
    ratio : float
        Error with all of them over the floor.
    where : sequence of str
        On which the residual depends before the first round.  It is what an unknown depends on:
        what patches leave, they may have brought in themselves.
    limit : Limits
        Up to where the latter is noise.
    """
    first, last = rounds[0], rounds[-1]
    if first.accepted is None:
        return first
    closed = [r for r in rounds if r.accepted is not None][-1].kind != "open"
    near = last.kind not in LACKING and ratio <= IMPERFECT
    much = total_share >= LEAST_SHARE_IF_FOREIGN
    patched = not closed and last.kind in LACKING and not much
    if patched or (first.kind == "open" and not (closed and (near or much))):
        return Verdict("unknown", None, (first.accepted,), tuple(where) or last.coordinates)
    named = {r.accepted.candidate.family for r in rounds if r.accepted is not None}
    rivals = tuple(t for r in rounds for t in _rivals(r) if t.candidate.family not in named)
    as_well = tuple(dict.fromkeys(c for r in rounds if r.accepted for c in r.as_well))
    if rivals or as_well:
        kind = "cannot be told apart"
    # At a floor that is known roughly what no right form leaves may be below the limit.
    elif ratio > limit.form or (ratio > IMPERFECT and first.kind == "form incomplete"):
        kind = "form incomplete"
    else:
        kind = first.kind if len(rounds) == 1 and first.kind != "open" else "effect"
    return Verdict(kind, first.accepted, rivals, last.coordinates, as_well)


def _rivals(one: Verdict) -> tuple[Trial, ...]:
    """Rivals of what a round accepted (the best candidate of an unknown is none)."""
    return one.rivals if one.accepted is not None else ()
