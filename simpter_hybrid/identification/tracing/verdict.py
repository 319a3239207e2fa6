"""What may be said of effects that were tried: the rules.

Thresholds follow the method study that the project starts from (largest gain by chance on 72 null
sets 1.3 %) and own recordings; each stands here with its reason.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..fitting.fitted_model import Trial
from .limits import IMPERFECT, Limits
from .locating import (
    CLEAN,
    FAINT,
    PLAIN,
    VIBRATION,
    before_ringing,
    located,
    or_slow,
    telling,
    without_coordinate,
)
from .named import coordinate_of, left_in_both
from .rivals import OFF_FLOOR, RIVAL, chosen, is_believed, rivals_of
from .signature import Dependence

#: Below this part explained, a candidate mimics something that is not in the library.
LEAST_SHARE = 0.4
#: With a foreign dependence left, the part explained must be at least this.
LEAST_SHARE_IF_FOREIGN = 0.9
#: A first effect that leaves more than half is named only if further ones account for it: of own
#: recordings right first effects explained 0.53 and more, a warm-up of what was dwell 0.43.
LEAST_SHARE_OF_FIRST = 0.5
#: With much left on no coordinate that can be told: effects that explained half of an own wear-in
#: were named; the right one of another form explains nine tenths.
LEAST_SHARE_IF_MUCH = 0.8
#: A wave that does not come again, but leaves what is noise and less than this part of all: own
#: ones of 1.7 waves in the way explained 0.9999 and left their place, steps of friction up to 0.87.
NEARLY_ALL = 0.99
#: What grows in a run grows with all else that does, so these stand for one another: beside another
#: of them an effect of one that ends off the floor must explain this part.  Of 55 own recordings
#: right effects ended off it once and explained 0.96; wrong ones 0.79 to 0.92, with their own
#: coordinate in the lead of what they left.
GROWING, LEAST_SHARE_IF_GROWING = ("time", "distance", "heat"), 0.95
#: A dependence left on an own coordinate speaks for a form to be mended only with this part of the
#: strongest's gain: on one that merely goes along with a foreign one it does not (own recordings
#: diagnosed with the true effect taken out of the library: asymmetry was called a drift, and drift
#: and dwell-breakaway wear while time stood for distance).
LEADING = 0.9
#: Up to so many times a floor estimated from single runs coloured noise of a drive may be all that
#: is left: a torque's that lasts ten samples ended at 2.8 times it.  Where the rest depends on
#: nothing (`COLOURED_ALONE`): noise that lasts n rows has 1.4 n times the slow part of white noise
#: with the same steps from row to row, and seven rows are soon reached.
COLOURED, COLOURED_ALONE = 3.0, 10.0
#: ... of a driver's own force, which nobody knows: a model of a motor whose constant was declared
#: four times too small left 130 times.
DRIVER_ALONE = 100.0
#: A name this many times above the floor must explain as much as where much is left (degressive
#: friction explained 0.71 of what a driver's dead band did and left 6.6 times the floor); of
#: one-way runs as much as beside a foreign dependence (of a slide that stuck and slipped three
#: wrong effects left 8.7 times the floor).
FAR_ABOVE = 3.0
#: Coordinates along which noise of a sensed drive shows.
NOISY = (":torque", ":acceleration")
#: Kinds of a verdict without an effect.
LACKING = ("unknown", "lack or noise")


@dataclass(frozen=True)
class Verdict:
    """What a survey of candidates allows to be said.

    Parameters
    ----------
    kind : str
        ``nothing missing``, ``effect``, ``form incomplete``, ``cannot be told apart``, ``unknown``,
        ``lack or noise`` (which of them cannot be told); of a single round also ``open``: a foreign
        dependence is left, and only if further effects account for it may this one be named.
    accepted : Trial or None
    rivals : tuple of Trial
        Of other families, not excluded by these data.
    coordinates : tuple of str
        On which what is left depends (before, if nothing was accepted), strongest first.
    as_well : tuple of str
        Foreign coordinates, a curve in which would do in these data what the accepted effect does.
    """

    kind: str
    accepted: Trial | None = None
    rivals: tuple[Trial, ...] = ()
    coordinates: tuple[str, ...] = ()
    as_well: tuple[str, ...] = ()


@dataclass(frozen=True)
class Evidence:
    """What one round of a search has shown.

    Parameters
    ----------
    trials : sequence of Trial
    before, after : sequence of Dependence
        Of the residual without and with `best_form(trials)`.
    floor : float
        Error of a perfect model, in standard deviations.
    ratio : float
        Error before over the floor.
    limit : Limits
        Up to where that is noise.
    least : float
        Gain asked for.
    one_way : bool
        All motion is one way: what grows in a run grows with all else, so no name is plain beside
        a foreign dependence that is left.
    found : sequence of str
        Coordinates of the effects that earlier rounds have found: if nothing else is left, their
        forms are to be mended.
    mistakable : mapping of str to float
        Foreign coordinate -> part of what `best_form(trials)` does that a curve in it does too:
        with `RIVAL` or more of it these data cannot carry a name, whatever the error after.
    """

    trials: Sequence[Trial]
    before: Sequence[Dependence]
    after: Sequence[Dependence]
    floor: float
    ratio: float
    limit: Limits
    least: float
    one_way: bool
    found: Sequence[str]
    mistakable: Mapping[str, float]

    @property
    def plain(self) -> tuple[str, ...]:
        """Coordinates on which the residual depends beyond chance, before the effect is added."""
        return telling(self.before, self.ratio, self.limit.dependence, self.limit.clean)


def judge(shown: Evidence) -> Verdict:
    """The verdict on one round."""
    limit, floor = shown.limit, shown.floor
    best = chosen(shown.trials, shown.least)
    if best is None or not is_believed(best, shown.least):
        return without_effect(shown.before, shown.ratio, shown.limit)
    left = located(shown.after, least=limit.dependence)
    own = set(best.candidate.coordinates)
    leads = located(shown.after, alike=LEADING, least=limit.dependence)
    foreign = not (set(leads) & own or set(left) <= own.union(shown.found))
    # What is left along its own coordinate in the drive's balance as well, it does not change.
    foreign |= bool(left_in_both(best.candidate.acts_on, own, left))
    # What a wave leaves on the place says that it is none, however near a floor known roughly; but
    # for what is next to nothing of what it takes away.
    leaves = bool(own & {*left}) and best.share < NEARLY_ALL
    another = _not_again(best) and (best.select_error > limit.form * floor or leaves)
    if best.share < LEAST_SHARE or another:
        return _explains_too_little(shown, best, left)
    # Of a floor that is an estimate, an error near it while something is left says no more; nor
    # does that of a wave which comes less than twice: much else looks so (46 turns long, of 33).
    once = _not_again(best)
    vague = shown.one_way or (bool(left) and limit.form > OFF_FLOOR) or once
    rivals = rivals_of(best, shown.trials, floor, vague, 0.0 if once else RIVAL)
    as_well = tuple(c for c, part in shown.mistakable.items() if part >= RIVAL)
    # What a form that is not the right one leaves on its own coordinate a curve in it takes away.
    if shown.one_way and (foreign or best.select_error > limit.form * floor):
        as_well = tuple(dict.fromkeys((*as_well, *left)))
    much = best.select_error > max(limit.form, IMPERFECT) * floor
    far = best.select_error > FAR_ABOVE * floor
    needed = LEAST_SHARE_IF_FOREIGN if foreign or (far and shown.one_way) else LEAST_SHARE
    # Much is left and none of it on its own coordinate: no form of this effect would take it away.
    if far or (much and not left and not _rings_on(own, shown.after)):
        needed = max(needed, LEAST_SHARE_IF_MUCH)
    if not shown.found and best.select_error > limit.form * floor:
        needed = max(needed, LEAST_SHARE_OF_FIRST)
    slow = _grow(own)
    alone = slow == {coordinate_of(c) for c in own}
    if best.select_error > limit.form * floor and alone and _grow(left) - slow:
        needed = max(needed, LEAST_SHARE_IF_GROWING)
    if best.share < needed:
        return Verdict("open", best, rivals, left, as_well)
    if rivals or as_well:
        return Verdict("cannot be told apart", best, rivals, left, as_well)
    # Where blocks are few, or the floor is known roughly, one near it tells of no lack by chance.
    shows = limit.clean <= CLEAN or best.select_error > limit.clean * floor
    incomplete = (bool(left) and not foreign and shows) or best.select_error > limit.form * floor
    return Verdict("form incomplete" if incomplete else "effect", best, (), left)


def _grow(named: Iterable[str]) -> set[str]:
    """Those of the coordinates that grow in a run."""
    return {coordinate_of(c) for c in named} & {*GROWING}


def _not_again(trial: Trial) -> bool:
    """Whether a trial is a wave that does not come again often enough: much else looks like it."""
    number = trial.fit.values.get(f"{trial.candidate.name}.number", np.inf)
    return number < trial.candidate.again


def without_effect(before: Sequence[Dependence], ratio: float, limit: Limits) -> Verdict:
    """No candidate helps: nothing is missing, or nothing that is known.

    Parameters
    ----------
    before : sequence of Dependence
        Of the residual.
    ratio : float
        Error over the floor.
    limit : Limits
    """
    plain = telling(before, ratio, limit.dependence, limit.clean)
    if not plain and ratio <= limit.lack:
        return Verdict("nothing missing" if ratio <= limit.doubt else "lack or noise")
    where, none = plain, without_coordinate(before)
    if ratio > limit.lack:  # then a weak one tells on what
        where = telling(before, ratio) or none
    found = _lack(where, plain or none, ratio, limit)
    return replace(found, coordinates=or_slow(found.coordinates, before))


def _explains_too_little(shown: Evidence, best: Trial, left: tuple[str, ...]) -> Verdict:
    """Verdict where the best candidate leaves most of the lack, or seems to stand for another.

    The kinds are ``nothing missing``, ``lack or noise`` and ``unknown``.
    """
    if shown.ratio <= shown.limit.form and not shown.plain:
        return Verdict("nothing missing")
    before = shown.before
    sure = before_ringing(located(before), before, shown.ratio)
    sure = sure or without_coordinate(before, PLAIN) or left
    where = or_slow(sure or located(before, p_value=FAINT) or without_coordinate(before), before)
    # Single windows in which noise moves an event are fitted by many effects a little; so is slow
    # noise, and a driver's own force, which nobody knows where nothing was repeated.  What is faint
    # is no evidence there: of a dozen coordinates one is by chance.  Of what acts anew in each run
    # a few repeated ones tell roughly how large it is.
    single = shown.limit.estimated and _may_be_slow(shown.ratio, shown.limit)
    told = shown.plain or ((sure or without_coordinate(before)) if single else where)
    apart = shown.limit.apart and shown.ratio <= COLOURED
    if (single or apart or shown.ratio <= shown.limit.lack) and not told:
        return Verdict("lack or noise", None, (best,))
    return Verdict("unknown", None, (best,), where)


def _lack(
    where: tuple[str, ...], plain: tuple[str, ...], ratio: float, limit: Limits
) -> Verdict:  # fmt: skip
    """Something unknown; or what noise of a sensor may be too.

    Noise of a recorded drive shows `plain` in no coordinate but the torque itself and the
    acceleration that it makes (in single runs any other may go along with a little of it by
    chance), slow noise of what is compared in none, nor that of a driver (`DRIVER_ALONE`).
    """
    single = limit.estimated
    told = plain if single and limit.drive else where
    if single and not told:
        untold = _may_be_slow(ratio, limit)
    else:
        noise = all(c.endswith(NOISY) and not c.startswith(VIBRATION) for c in told)
        untold = noise and limit.drive and ratio <= COLOURED
    return Verdict("lack or noise" if untold else "unknown", coordinates=where)


def _may_be_slow(ratio: float, limit: Limits) -> bool:
    """Whether noise that shows on no coordinate may be so large: see `COLOURED_ALONE`."""
    return ratio <= (DRIVER_ALONE if limit.told else COLOURED_ALONE)


def _rings_on(own: set[str], after: Sequence[Dependence]) -> bool:
    """Whether the spread that is left is strongest along a coordinate of the effect's own.

    What yields and rings is wrong by its phase: no mean force is left of it, and much spread.
    """
    names = {coordinate_of(c) for c in own}
    rings = located(after, VIBRATION, alike=LEADING)
    return any(coordinate_of(c) in names for c in rings)
