"""What may be said of a whole search, round after round."""

from __future__ import annotations

from collections.abc import Sequence

from ..fitting.fitted_model import Trial
from .limits import IMPERFECT, REPEATED, Limits
from .locating import VIBRATION
from .named import REVERSAL, balance_of, coordinate_of
from .ringing import RINGING
from .slow_state import RUN
from .verdict import FAR_ABOVE, LACKING, LEAST_SHARE_IF_FOREIGN, LEAST_SHARE_IF_MUCH, Verdict

#: Part of the lack that all effects explain at least where nothing is left on anything and what
#: came last is closed.  Patches leave something: so did each of 17 own searches that took some
#: effect for one that had been taken out.  A tester's right pair left nothing, and explained 0.785.
LEAST_SHARE_OF_ALL = 0.7
#: ... and where a force is left that depends on a coordinate, above what a right form leaves: of
#: own recordings diagnosed without their effect, a scale of the command explained 0.93 and 0.94 of
#: a power of it (and left 0.14 and 0.21 of the square on what goes with the command), the power
#: 0.91 of the scale, two effects of the coil 0.92 of a slow release; right ones with as much left
#: explained 0.96 and more.
LEAST_SHARE_IF_LEFT = 0.95
#: Balances in which no force is told.
NO_FORCE = ("breakaway", RINGING, VIBRATION)


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
    not in the library, each of them open; what is left on few levels, on nothing or, of what gives
    way, as ringing is not foreign), and with all of them little is left.
    Nor is anything named where what came last is open, leaves a lack and, with all before, much of
    it, or where two effects that go by the same leave much, or what a further round saw: patches;
    nor where a force that depends on a coordinate is left above what a right form leaves, and no
    more than nineteen twentieths are explained (by what gives way seven tenths): then the law is
    another one.

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
    lacks = _lacks_more(rounds, total_share)
    near = not lacks and ratio <= IMPERFECT
    much = total_share >= LEAST_SHARE_IF_FOREIGN
    patched = not closed and last.kind in LACKING and not much
    little = total_share < LEAST_SHARE_IF_MUCH or (lacks and not much)
    alike = ratio > limit.form and little and _go_by_the_same(rounds)
    patched |= alike or (first.kind == "open" and not (closed and (near or much)))
    named = {r.accepted.candidate.family for r in rounds if r.accepted is not None}
    rivals = tuple(t for r in rounds for t in _rivals(r) if t.candidate.family not in named)
    as_well = tuple(dict.fromkeys(c for r in rounds if r.accepted for c in r.as_well))
    another = ratio > _sure(limit) and _leaves_forces(rounds) and total_share < _needed(rounds)
    if patched or (another and not (rivals or as_well)):
        return Verdict("unknown", None, (first.accepted,), tuple(where) or last.coordinates)
    if rivals or as_well:
        kind = "cannot be told apart"
    # At a floor that is known roughly what no right form leaves may be below the limit; and what
    # came last may have left something on its own coordinate.
    elif (
        ratio > limit.form
        or (ratio > IMPERFECT and first.kind == "form incomplete")
        or (len(rounds) > 1 and last.kind == "form incomplete" and last.coordinates)
    ):
        kind = "form incomplete"
    else:
        kind = first.kind if len(rounds) == 1 and first.kind != "open" else "effect"
    return Verdict(kind, first.accepted, rivals, last.coordinates, as_well)


def _lacks_more(rounds: Sequence[Verdict], total_share: float) -> bool:
    """Whether the last round's lack, which no effect explains, says that those found are patches.

    What is little and on nothing imperfect forms leave too.  Levels of breakaway are a dozen and
    hardly raise the error.  What gives way and rings is wrong by its phase, so that after it no
    force is left, but much ringing and spread.
    """
    last, quiet = rounds[-1], {"breakaway"}
    own = {coordinate_of(c) for r in rounds if r.accepted for c in r.accepted.candidate.coordinates}
    if REVERSAL in own:
        quiet |= {RINGING, VIBRATION}
    little = bool(last.coordinates) or total_share >= LEAST_SHARE_OF_ALL
    hardly = little and all(balance_of(c) in quiet for c in last.coordinates)
    return last.kind in LACKING and not hardly


def _sure(limit: Limits) -> float:
    """Error over the floor beyond which no right form ends: a rough floor may be far too low."""
    return FAR_ABOVE if limit.estimated or limit.drive else limit.form


def _leaves_forces(rounds: Sequence[Verdict]) -> bool:
    """Whether a force is left at the end that depends on a coordinate."""
    forces = [c for c in rounds[-1].coordinates if coordinate_of(c) != RUN]
    return any(balance_of(c) not in NO_FORCE for c in forces)


def _needed(rounds: Sequence[Verdict]) -> float:
    """Part of the lack that is to be explained where a force is left.

    Less by what gives way: it is wrong by its phase, which may leave a force on any coordinate.  An
    own right one explained 0.745; backlash, in place of springs that yield, 0.54.
    """
    own = {coordinate_of(c) for r in rounds if r.accepted for c in r.accepted.candidate.coordinates}
    return LEAST_SHARE_OF_ALL if REVERSAL in own else LEAST_SHARE_IF_LEFT


def _go_by_the_same(rounds: Sequence[Verdict]) -> bool:
    """Whether all coordinates of one accepted effect are those of another, of another family.

    Of a lag that was taken out of the library a ramp of the supply and a pull-in, which both go by
    how the drive changes, took away three quarters as a form that seemed incomplete.
    """
    found = [r.accepted.candidate for r in rounds if r.accepted is not None]
    pairs = ((a, b) for k, a in enumerate(found) for b in found[:k] if a.family != b.family)
    return any(
        {*a.coordinates} <= {*b.coordinates} or {*b.coordinates} <= {*a.coordinates}
        for a, b in pairs
    )


def _rivals(one: Verdict) -> tuple[Trial, ...]:
    """Rivals of what a round accepted (the best candidate of an unknown is none)."""
    return one.rivals if one.accepted is not None else ()
