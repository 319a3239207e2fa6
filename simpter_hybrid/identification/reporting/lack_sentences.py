"""What a diagnosis says where it names no effect."""

from __future__ import annotations

from ..empirical import Empirical, settles
from ..fitting.residual import rms
from ..result import Diagnosis
from ..tracing.limits import OFF_NOISE, REPEATED
from ..tracing.locating import located
from ..tracing.rivals import OFF_FLOOR
from ..tracing.round import above_floor
from ..tracing.traced import of_all_balances
from ..tracing.verdict import COLOURED, COLOURED_ALONE, DRIVER_ALONE
from ..untested import untested
from .dependence_text import SAME, among_others, depends_on, is_straight
from .held_out_sentences import (
    NEXT_TO_NOTHING,
    curve_does_next_to_nothing,
    floor_known_by,
    held_out,
    held_out_text,
    most_carried_over,
    taken_back_text,
    times,
)
from .nearest import nearest_text
from .refits import far_refits

#: Nulls on encoders end at 0.7 times the floor; what ends below this was allowed too much noise.
FAR_BELOW = 0.5
FAR_BELOW_TEXT = (
    " That is far below the noise that was allowed for, which would hide a lack of that size: are "
    "the noise and the step of each channel in the map right?"
)
#: Kinds of rounds after which it is not the runs held out alone that show a lack.
TELL_OF_A_LACK = {"form incomplete", "unknown"}


def lack_sentence(found: Diagnosis) -> str:
    """The sentence on a verdict without an effect."""
    if found.taken_back is not None:
        return _of_taken_back(found)
    nothing = found.search.verdict.kind == "nothing missing"
    return _of_nothing(found) if nothing else _of_a_lack(found)


def _of_nothing(found: Diagnosis) -> str:
    ratio, held = found.search.corrected.select_error / found.search.floor, held_out_text(found)
    if held_out(found) > most_carried_over(found):
        return (
            "Nothing that the runs that fit and select show is missing (on the latter the error is "
            f"{ratio:.2f} times the floor), but it is {held}: something is missing that only these "
            "show, or the model sticks there where the rig moved on, or the other way round. Let "
            "some of their kind fit or select as well."
        )
    if ratio <= OFF_FLOOR:
        far = FAR_BELOW_TEXT if ratio < FAR_BELOW else ""
        if ratio < 1.0 / OFF_FLOOR and found.limits is REPEATED:
            less = "the refitted model leaves less than repeated runs differ by"
            return f"Nothing is missing that these runs could show: {less} ({held}).{far}"
        but = f" beside {beside}" if (beside := ", ".join(far_refits(found))) else ""
        return f"Nothing is missing{but}: what the refitted model leaves is noise ({held}).{far}"
    along = located(of_all_balances(found.search.rounds[0].before)) if found.search.rounds else ()
    left = "depends on nothing that was looked at"
    if along:
        on = depends_on(along, is_straight(found))
        left = f"may be noise so near the floor, though it goes along with {on}"
    return (
        "Nothing that these data could show is missing: none of the known effects "
        f"{_helps(found)}, and what is left {left}. It is {held}, {ratio:.2f} times on those that "
        f"select{_would_tell(found)}."
    )


def _of_lack_or_noise(found: Diagnosis) -> str:
    on = depends_on(found.search.verdict.coordinates, is_straight(found))
    ratio = found.search.corrected.select_error / found.search.floor
    remark = untested(found.remarks)
    near = remark is not None and ratio <= found.limits.lack
    # What runs held out show, though others could not, is far from what any model would do.
    if found.only_held_out or (near and held_out(found) > most_carried_over(found)):
        why = f"; {remark.what}, {remark.value}" if remark is not None else ""
        tells = _would_tell(found) if remark is None else ""  # the same once more tests nothing
        return (
            "It cannot be told whether something is missing: the runs that fit and select show "
            f"nothing (on the latter the error is {ratio:.2f} times the floor{why}), but it is "
            f"{held_out_text(found)}. These may show what the others do not, or have more "
            f"noise. Let some of their kind fit or select as well{tells}."
        )
    if found.off_pace:
        return (
            "It cannot be told whether something is missing: the error is "
            f"{held_out_text(found)}, {ratio:.2f} times on those that select, but half of a "
            "straight line in positions counts for nothing, and by such lines the model goes "
            "another way than the record."
        )
    if near and remark is not None:
        return (
            f"It cannot be told whether something is missing: {remark.what} ({remark.value}), and "
            "so nearly every model would do as well as this one. Are the columns and their units "
            "right? Move farther or faster, or log the speed, or a finer position."
        )
    if _of_the_driver(found):
        return (
            "Something is missing, in the model or in what the driver gave for what it was "
            f"told: {_times_the_floor(found, floor_known_by(found))}, which is more than noise "
            f"of a sensor. None of the known effects {_helps(found)}, and it depends on {on}"
            f"{_would_tell(found)}."
        )
    return (
        "It cannot be told whether something is missing: "
        f"{_times_the_floor(found, floor_known_by(found))}, none of the known effects "
        f"{_helps(found)}, and it depends on {on}. {_noise_that(found)} would look so too"
        f"{_would_tell(found)}."
    )


def _of_a_lack(found: Diagnosis) -> str:
    done, verdict = found.search, found.search.verdict
    if verdict.kind == "lack or noise":
        return _of_lack_or_noise(found)
    on = depends_on(verdict.coordinates, is_straight(found))
    if not verdict.coordinates:
        return (
            f"Something is missing: {_times_the_floor(found, 'floor')}. None of the known effects "
            f"explains it{nearest_text(found)}, and it depends on {on}{_would_tell(found)}."
        )
    seen = [d for first in done.rounds[:1] for d in of_all_balances(first.before)]
    others = among_others(verdict.coordinates, seen, is_straight(found))
    on += "" if others and _settled_by_a_curve(found) else others
    unknown = f"Something is missing and none of the known effects explains it{nearest_text(found)}"
    if found.empirical is not None:  # whose sentence says how much is left
        if _untold_by(found.empirical, found):
            return f"{unknown}. On what it depends these runs do not tell."
        if not_so := _not_held_out(found):
            return f"{unknown}. By the runs that fit and select it depends on {on}; {not_so}."
        return f"{unknown}: it depends on {on}."
    if held_out(found) <= OFF_FLOOR < (chosen := done.corrected.select_error / done.floor):
        return (
            f"{unknown}: it depends on {on}. The error stays at {times(chosen)} times the floor on "
            f"the runs that select; those held out do not show it ({times(held_out(found))} times)."
        )
    return f"{unknown}: it depends on {on}. The error stays at {held_out_text(found)}."


def _settled_by_a_curve(found: Diagnosis) -> bool:
    """Whether a curve over one coordinate leaves noise: no other one tells anything then."""
    done, term = found.search, found.empirical
    most = found.limits.form * done.floor
    return term is not None and settles(term, done.corrected.select_error, most)


def _untold_by(term: Empirical, found: Diagnosis) -> bool:
    """Whether a curve over all that single runs located takes hardly any of their error away.

    Neither of that of the runs that select nor of those held out: of a dozen coordinates one goes
    along with a little of slow noise.  The sentence on the curve says which.
    """
    if not found.limits.estimated or not curve_does_next_to_nothing(found):
        return False
    asked = SAME if term.coordinate in SAME else (term.coordinate,)
    alone = {*found.search.verdict.coordinates} <= {*asked}
    return alone and term.trial.gain < 1.0 - NEXT_TO_NOTHING


def _not_held_out(found: Diagnosis) -> str:
    """Words that the runs held out do not show what a curve is drawn over; "" if they do."""
    if found.error_by_stage["empirical"] >= found.error_by_stage["after"]:
        return "the runs held out do not show that"
    hardly = found.limits.estimated and curve_does_next_to_nothing(found)
    return "the runs held out hardly show that" if hardly else ""


def _of_taken_back(found: Diagnosis) -> str:
    """Sentence on a search whose effects the runs held out contradict."""
    verdict, told = found.search.verdict, f"{taken_back_text(found)}{_fitted_beside(found)}"
    if verdict.kind == "nothing missing":
        return (
            f"Nothing is missing that all of these runs show: {told}. What the refitted model "
            f"leaves is {held_out_text(found)}{_would_tell(found)}."
        )
    if verdict.kind == "lack or noise":
        return f"It cannot be told whether something is missing: {told}{_would_tell(found)}."
    lack = f"Something is missing and none of the known effects explains it: {told}"
    if not verdict.coordinates:
        return f"{lack}{_would_tell(found)}."
    on = depends_on(verdict.coordinates, is_straight(found))
    return f"{lack}. By the runs that fit and select it depends on {on}."


def _fitted_beside(found: Diagnosis) -> str:
    """Words on the fitted runs, where these alone show that something is missing; else ""."""
    done = found.search
    above = above_floor(done.refitted, done.floor, found.floors.fit)
    if not done.refitted.select_error / done.floor <= found.limits.lack < above:
        return ""
    return f". On the fitted runs the refitted model leaves {times(above)} times the floor"


def noise_left_text(found: Diagnosis) -> str:
    """Sentences that what effects leave may be noise, and which run tells; "" where it is none.

    It may where the floor is an estimate and the last round, which no effect helped, told no lack,
    or runs held out alone show one.
    """
    done = found.search
    kinds = [r.verdict.kind for r in done.rounds]
    if not found.limits.estimated or not kinds:
        return ""
    near = done.corrected.select_error <= found.limits.form * done.floor
    if near and done.verdict.kind == "form incomplete" and not {*kinds} & TELL_OF_A_LACK:
        return (
            " Only the runs held out leave so much: they may show what the others do not, or have "
            "more noise."
        )
    if kinds[1:] == [] or kinds[-1] not in ("lack or noise", "nothing missing"):
        return ""
    return (
        f" {_noise_that(found)} would look so too{_would_tell(found)}. The intervals of the sizes "
        "know nothing of such noise."
    )


def _of_the_driver(found: Diagnosis) -> bool:
    """Whether only the force of a driver, which nobody logged, could be so far off by itself."""
    if not found.limits.told:
        return False
    most = COLOURED if _rounding_is_all(found) else COLOURED_ALONE
    return found.search.corrected.select_error > most * found.search.floor


def _rounding_is_all(found: Diagnosis) -> bool:
    """Whether the sensors compared are told to round, and no other noise of theirs is.

    What rounding leaves out is half a step at most, 1.7 times its own floor, however slow it is.
    """
    if found.recording is None:
        return False
    names = {name for runs in found.split.report for name in runs.observed}
    channels = [found.recording.channels.get(name) for name in names]
    stepped = [c is not None and c.step is not None and c.noise is None for c in channels]
    return bool(stepped) and all(stepped)


def _noise_that(found: Diagnosis) -> str:
    """Words for noise of unknown size that may be all that is left."""
    sensors = "noise of a sensor that is larger or slower than was allowed for"
    if found.limits.form > OFF_NOISE:
        return f"What the coarse sensor of the drive rounds away, or {sensors},"
    return f"A driver's own force, or {sensors}," if found.limits.told else sensors.capitalize()


def _helps(found: Diagnosis) -> str:
    if found.search.rounds and not found.search.rounds[0].trials:
        return "promises enough to be fitted where the floor is so uncertain"
    near = nearest_text(found)
    return f"explains it{near}" if near else "helps"


def _would_tell(found: Diagnosis) -> str:
    """Advice to drive a run once more, where that would tell noise from a lack; else ""."""
    most = DRIVER_ALONE if found.limits.told else COLOURED_ALONE
    done = found.search
    far = above_floor(done.corrected, done.floor, found.floors.fit) > most
    if not found.limits.estimated or far:
        return ""
    recording = found.recording
    how = "driven" if recording is None or recording.map.driven else "let go"
    own = "what a driver gives by itself" if _of_the_driver(found) else "noise"
    return f". A run that fits, {how} the same way once more, would tell: {own} does not come again"


def _times_the_floor(found: Diagnosis, what: str) -> str:
    done = found.search
    fitted = rms(done.refitted.residuals) / found.floors.fit
    ratio = done.corrected.select_error / done.floor
    return (
        f"the error is {fitted:.2f} times the {what} on the fitted runs and {ratio:.2f} times on "
        "those that select"
    )
