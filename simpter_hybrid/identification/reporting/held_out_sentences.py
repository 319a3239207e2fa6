"""What a diagnosis says of the runs held out: they had no part in any choice."""

from __future__ import annotations

from ..carried_over import WORSE, carried_over
from ..empirical import Empirical
from ..empirical_terms import goes_by
from ..result import Diagnosis
from ..tracing.limits import IMPERFECT
from .dependence_text import depends_on, is_straight

#: Channel of the levels of breakaway, and beginning of the coordinates on which they depend.
BREAKAWAY = "breakaway"
LEVELS = "the levels of breakaway"
#: A channel is predicted worse if its error is so many times what it was, and its floor: of four
#: right names of a tester's levels of breakaway rose to 1.2 times what they were.
SPOILT = 1.5
#: What the floor is where nothing was repeated and the map says how large noise is.
DECLARED = "noise declared in the map"
#: A curve that leaves this part of an error is not what is missing.
NEXT_TO_NOTHING = 0.95
#: An effect that leaves this part of what a curve does is the better correction.
CLEARLY_LESS = 0.95


def held_out(found: Diagnosis, stage: str = "after") -> float:
    """Error of a stage on the runs held out, over the floor."""
    return found.error_by_stage[stage] / found.floors.report


def most_carried_over(found: Diagnosis) -> float:
    """Error, over the floor, up to which the runs held out show no more than the selecting ones."""
    return carried_over(found.search.corrected.select_error / found.search.floor)


def held_out_text(found: Diagnosis) -> str:
    """The error after, on the runs held out, in words."""
    return f"{times(held_out(found))} times the {floor_known_by(found)} on runs held out"


def floor_known_by(found: Diagnosis) -> str:
    """What the floor is: where nothing was repeated the noise that the map declares, or a guess.

    Of a drive that a sensor saw the noise is in the floor as well.
    """
    usual = found.limits.known_by
    if not found.limits.estimated or (recording := found.recording) is None:
        return usual
    compared = {name for replay in found.split.report for name in replay.observed}
    # Of a motion that is set its noise is in the floor too, by what it does to forces.
    drives = {
        n for n, c in recording.channels.items()
        if c.role == "input" and (found.limits.drive or n.startswith(("position", "speed")))
    }  # fmt: skip
    told = [recording.channels[n].noise for n in (compared | drives) & recording.channels.keys()]
    return DECLARED if told and None not in told else usual


def times(ratio: float) -> str:
    """A ratio to the digits that a floor allows: near 1 to a thousandth, to be compared."""
    return f"{ratio:.3f}" if ratio < 2.0 else f"{ratio:.2f}" if ratio < 10.0 else f"{ratio:.0f}"


def curve_does_next_to_nothing(found: Diagnosis) -> bool:
    """Whether more than noise is left on the runs held out, and a curve takes hardly any of it."""
    before = held_out(found)
    return before > IMPERFECT and held_out(found, "empirical") > NEXT_TO_NOTHING * before


def curve_sentence(found: Diagnosis) -> str:
    """Sentence on what an empirical curve does, if one was fitted."""
    term = found.empirical
    if term is None:
        return ""
    over = depends_on([goes_by(term.coordinate)], is_straight(found))
    before, after = held_out(found), held_out(found, "empirical")
    law = "it is no law and says nothing beyond the range that was recorded"
    if curve_does_next_to_nothing(found) and after < before:
        return (
            f"An empirical curve over {over} takes next to nothing of it away (runs held out: "
            f"{before:.2f} to {after:.2f} times the floor): what is missing goes along with "
            f"{over} here, and is no matter of it alone."
        )
    if after < before:
        return (
            f"An empirical curve over {over} lowers the error of the runs held out from "
            f"{before:.2f} to {after:.2f} times the floor; {law}.{_nearer_by_hand(found, term)}"
        )
    chosen = found.search.corrected.select_error / found.search.floor
    lowers = (
        f"An empirical curve over {over} lowers the error of the runs that select from "
        f"{chosen:.2f} to {term.model.select_error / found.search.floor:.2f} times the floor"
    )
    if f"{after:.2f}" == f"{before:.2f}":
        return f"{lowers}; the runs held out, at {before:.2f} times, do not show it."
    return (
        f"{lowers}, but raises that of the runs held out from {before:.2f} to {after:.2f}: it does "
        "not carry over to them."
    )


def _nearer_by_hand(found: Diagnosis, term: Empirical) -> str:
    """Sentence on an effect that explains too little to be named, and leaves less than the curve.

    The knots of a curve over a turn stand too far apart for three waves of it.
    """
    done = found.search
    best = done.rounds[0].best if done.rounds and not done.corrected.effects else None
    if best is None or best.select_error >= CLEARLY_LESS * term.model.select_error:
        return ""
    ends = (x / done.floor for x in (best.select_error, term.model.select_error))
    by, curve = (f"{end:.3g}" for end in ends)
    return (
        f" As a correction {best.candidate.name}, whose sizes stand among the candidates, leaves "
        f"less ({by} against {curve} times the floor on the runs that select)."
    )


def taken_back_text(found: Diagnosis) -> str:
    """Words on what the runs held out contradict, and by how much; "" if nothing."""
    back = found.taken_back
    if back is None:
        return ""
    (before, after), (known, with_it) = back.select, back.held_out
    one = len(back.names) == 1
    without = "as declared" if back.declared else "without"
    lowers, it, named = ("lowers", "it", "it is") if one else ("lower", "them", "they are")
    return (
        f"{' and '.join(back.names)} {lowers} the error of the runs that select from {before:.2f} "
        f"to {after:.2f} times the floor, but those held out have {with_it:.2f} with {it} and "
        f"{known:.2f} {without}: {named} not named"
    )


def harmful_sentence(found: Diagnosis) -> str:
    """Sentence on further effects that only the runs which select asked for; "" without any."""
    if not found.harmful:
        return ""
    said = "; ".join(
        f"with {one.name} they have {one.with_it:.3g}, without it {one.without:.3g} times the floor"
        for one in found.harmful
    )
    one = len(found.harmful) == 1
    names = " and ".join(one.name for one in found.harmful)
    return (
        f"{names[0].upper()}{names[1:]} lowered the error of the runs that select further, and "
        f"that of the runs held out rises by {'it' if one else 'them'} ({said}): "
        f"{'it is' if one else 'they are'} not named."
    )


def worse_sentence(found: Diagnosis) -> str:
    """Sentence that the corrected model predicts runs held out worse than one without; else ""."""
    after = held_out(found)
    for stage in ("declared", "refitted"):
        before = held_out(found, stage)
        if after > WORSE * before:
            if _plainly_better(found, stage):
                return (
                    f"On the runs held out the corrected model is worse than the {stage} one as "
                    f"noise weighs it ({after:.4g} against {before:.4g} times the floor), and "
                    "better in every channel's plain error: the noise that was estimated rules "
                    "this. Give the sensor's (`noise` in the map), if it is known."
                )
            return (
                f"On the runs held out the corrected model is worse than the {stage} one "
                f"({after:.4g} against {before:.4g} times the floor): what was fitted does not "
                "carry over to them."
            )
    return _levels_worse(found) or _channels_worse(found)


def _plainly_better(found: Diagnosis, stage: str) -> bool:
    """Whether every channel's plain error is smaller after than it was."""
    before, after = (found.errors.get(name, {}) for name in (stage, "after"))
    return bool(after) and all(after[c] < before.get(c, 0.0) for c in after)


def _levels_worse(found: Diagnosis) -> str:
    """Sentence that an effect on breakaway predicts levels worse, which instants made up for."""
    effects = found.search.corrected.effects
    names = [e.name for e in effects if any(c.startswith(BREAKAWAY) for c in e.coordinates)]
    before, after, floor = (
        found.errors.get(stage, {}).get(BREAKAWAY, 0.0) for stage in ("refitted", "after", "floor")
    )
    falls = held_out(found) < held_out(found, "refitted")
    worse = floor > 0.0 and after > max(WORSE * before, IMPERFECT * floor)
    if not (names and falls and worse):  # where nothing was repeated the scatter is not known
        return ""
    return (
        f"The runs held out break away at levels that are predicted worse with "
        f"{' and '.join(names)} ({after / floor:.2f} against {before / floor:.2f} times the "
        "scatter), though the error of all falls: take the size for a hint, and let ramps to "
        "breakaway after other rests and at other levels tell."
    )


def _channels_worse(found: Diagnosis) -> str:
    """Sentence on channels that what was found predicts worse, which the others made up for.

    A few levels of breakaway weigh next to nothing beside all rows of a torque: of an asymmetry of
    slip friction alone, found as one of all friction, they rose from 0.9 to 3 times their scatter.
    """
    effects = [e.name for e in found.search.corrected.effects]
    before, after, floor = (found.errors.get(k, {}) for k in ("refitted", "after", "floor"))
    worse = [
        f"{LEVELS if c == BREAKAWAY else c.replace('_', ' ')} ({after[c] / floor[c]:.2f} against "
        f"{before[c] / floor[c]:.2f} times what repeated runs differ by)"
        for c in after
        if floor.get(c) and c in before and after[c] > SPOILT * max(before[c], floor[c])
    ]
    if not (effects and worse):
        return ""
    return (
        f"With {' and '.join(effects)} the runs held out are predicted worse in "
        f"{' and '.join(worse)}, though the error of all falls: what was found acts otherwise "
        "there."
    )
