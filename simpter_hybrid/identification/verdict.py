"""What may be said of effects that were tried: the rules.

Thresholds follow the method study that the project starts from (largest gain by chance on 72 null
sets 1.3 %) and own recordings; each stands here with its reason.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from .locating import (
    FAINT,
    LEAST_DEPENDENCE,
    PLAIN,
    VIBRATION,
    located,
    telling,
    without_coordinate,
)
from .search import AT_FLOOR, Trial
from .signature import Dependence

#: Least relative fall of the held-out error for an effect to be accepted.
LEAST_GAIN = 0.02
#: ... or, of a first one, for that of the runs of one experiment: an effect that few runs can show
#: is diluted by all others.  Nulls gained 0.3 % so at most, effects that were missed 9 to 15 %.
LEAST_LOCAL = 0.05
#: ... and for a further one.  What an imperfect form leaves can be patched by many effects: that of
#: right effects is 5 to 10 % above the floor, and most of it no single effect takes away.
LEAST_FURTHER = 0.05
#: Below this part explained, a candidate mimics something that is not in the library.
LEAST_SHARE = 0.4
#: With a foreign dependence left, the part explained must be at least this.
LEAST_SHARE_IF_FOREIGN = 0.9
#: With much left on no coordinate that can be told: effects that explained half of an own wear-in
#: were named; the right one of another form explains nine tenths.
LEAST_SHARE_IF_MUCH = 0.8
#: A dependence left on an own coordinate speaks for a form to be mended only with this part of the
#: strongest's gain: on one that merely goes along with a foreign one it does not (own recordings
#: diagnosed with the true effect taken out of the library: asymmetry was called a drift, and drift
#: and dwell-breakaway wear while time stood for distance).
LEADING = 0.9
#: A rival that explains at least this part of what the best explains may be the true one ...
RIVAL = 0.8
#: ... unless the best is at the floor (`AT_FLOOR`) and the rival worse by what is believed of an
#: effect (`LEAST_GAIN`): evidence between two effects is weighed as evidence for one ...
#: ... or leaves this many times the error that the best leaves near the floor (loop study: 20 %).
CLEARLY_WORSE = 1.2
#: ... or this many times it wherever the best ends: of a lack fifty times the floor almost any
#: candidate explains four fifths in mean squares.
FAR_WORSE = 2.0
#: An error after this many times the floor is always said to be an incomplete form, and where
#: nothing helps, something unknown ...
OFF_FLOOR = 1.05
#: ... and more than this many times the floor more than the forms of right effects leave: those of
#: own recordings end up to 16 % above it.
IMPERFECT = 1.2
#: ... and without replicates this many: an estimate from single runs misses coloured noise.
OFF_NOISE = 1.5
#: Errors this near each other are alike: the candidate with fewest parameters is named first.
TIE = 0.003
#: A richer form of the same effect must lower the error by this to be preferred.
RICHER_FORM = 0.01


class Limits(NamedTuple):
    """Up to how many times the floor an error is noise.

    Parameters
    ----------
    lack : float
        Where no effect helps.
    form : float
        With an effect: beyond it its form is incomplete.
    dependence : float
        Part of the mean square that a dependence takes away which tells of a lack by itself.
    """

    lack: float = OFF_FLOOR
    form: float = OFF_FLOOR
    dependence: float = LEAST_DEPENDENCE


#: Where runs were repeated, which tells the floor.
REPEATED = Limits()
#: Where it is estimated from single runs.
SINGLE = Limits(OFF_NOISE, OFF_NOISE)
#: The same of a driven axis.  A drive that is sampled coarsely, or noise of it that is not white,
#: puts curves of up to a seventeenth into nulls: a tenth is asked.
SINGLE_AXIS = Limits(OFF_NOISE, OFF_NOISE, 0.1)
#: ... whose noise of inputs and starts is simulated: nulls end 0.79 to 1.14 times that floor.
SIMULATED_AXIS = Limits(OFF_NOISE, IMPERFECT, 0.1)
#: A robot's, which is simulated too: own nulls end 0.99 to 1.03 times that floor.
SIMULATED = Limits(OFF_NOISE, OFF_FLOOR)


@dataclass(frozen=True)
class Verdict:
    """What a survey of candidates allows to be said.

    Parameters
    ----------
    kind : str
        ``nothing missing``, ``effect``, ``form incomplete``, ``cannot be told apart``, ``unknown``;
        of a single round also ``open``: a foreign dependence is left, and only if further effects
        account for it may this one be named.
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


def best_form(trials: Sequence[Trial]) -> Trial | None:
    """Best trial, or the simplest that is as good, or a simpler form that is nearly as good."""
    if not trials:
        return None
    first = min(trials, key=lambda t: t.select)
    # Of a gain that all runs dilute: this part of the least that is believed of all.
    gained = min(1.0, max(first.gain, 0.0) / LEAST_GAIN)
    alike = [t for t in trials if t.select <= first.select * (1 + gained * TIE)]
    best = min(alike, key=lambda t: (len(t.candidate.parameters), t.select))
    family = [t for t in trials if t.candidate.family == best.candidate.family]
    near = [t for t in family if t.select <= best.select * (1 + gained * RICHER_FORM)]
    return min(near, key=lambda t: (len(t.candidate.parameters), t.select))


def is_believed(trial: Trial, least: float = LEAST_GAIN) -> bool:
    """Whether a trial lowers the error of runs not seen by more than chance does.

    Where more than `LEAST_GAIN` is asked only the error of all runs counts.
    """
    shown = least <= LEAST_GAIN and trial.gain > 0.0 and trial.local >= LEAST_LOCAL
    return trial.gain >= least or shown


def rivals_of(
    best: Trial, trials: Sequence[Trial], floor: float, one_way: bool = False
) -> tuple[Trial, ...]:
    """Trials of other families that explain nearly as much, best of each family first."""
    found: dict[str, Trial] = {}
    for trial in sorted(trials, key=lambda t: t.select):
        family = trial.candidate.family
        if family == best.candidate.family or not is_believed(trial):
            continue
        if best.candidate.name in trial.candidate.contains:
            continue
        worse = excluded(best.select, trial.select, floor, one_way)
        if _explained(trial) >= RIVAL * _explained(best) and not worse:
            found.setdefault(family, trial)
    return tuple(found.values())


def _explained(trial: Trial) -> float:
    """Part of the whole mean square: shares of it compare as those of a lack do."""
    return 1.0 - (1.0 - trial.gain) ** 2


def excluded(best: float, rival: float, floor: float, one_way: bool = False) -> bool:
    """Whether the errors of two models exclude the second.

    In `one_way` runs time, path and heat grow together, and a form that is not quite right costs
    more than what they differ by.
    """
    if not one_way and best <= AT_FLOOR * floor and rival > (1 + LEAST_GAIN) * best:
        return True
    if best <= OFF_FLOOR * floor and rival > CLEARLY_WORSE * best:
        return True
    return rival > FAR_WORSE * best


def judge(
    trials: Sequence[Trial],
    before: Sequence[Dependence],
    after: Sequence[Dependence],
    floor: float,
    mistakable: Mapping[str, float] | None = None,
    ratio: float = 1.0,
    limit: Limits = REPEATED,
    least: float = LEAST_GAIN,
    one_way: bool = False,
    found: Sequence[str] = (),
) -> Verdict:
    """The verdict on one round.

    Parameters
    ----------
    trials : sequence of Trial
    before, after : sequence of Dependence
        Of the residual without and with `best_form(trials)`.
    floor : float
        Error of a perfect model, in standard deviations.
    mistakable : mapping of str to float, optional
        Foreign coordinate -> part of what `best_form(trials)` does that a curve in it does too:
        with `RIVAL` or more of it these data cannot carry a name, whatever the error after.
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
    """
    best = best_form(trials)
    if best is None or not is_believed(best, least):
        where = telling(before, ratio, limit.dependence)
        lacks = bool(where) or ratio > limit.lack
        if lacks and not where:  # then a weak one tells on what
            where = telling(before, ratio) or without_coordinate(before)
        return Verdict("unknown" if lacks else "nothing missing", None, (), where)
    left = located(after, least=limit.dependence)
    own = set(best.candidate.coordinates)
    leads = located(after, alike=LEADING, least=limit.dependence)
    foreign = not (set(leads) & own or set(left) <= own.union(found))
    if best.share < LEAST_SHARE:
        if ratio <= limit.form and not telling(before, ratio, limit.dependence):
            return Verdict("nothing missing")
        where = located(before) or without_coordinate(before, PLAIN) or left
        where = where or located(before, p_value=FAINT) or without_coordinate(before)
        return Verdict("unknown", None, (best,), where)
    rivals = rivals_of(best, trials, floor, one_way)
    as_well = tuple(c for c, part in (mistakable or {}).items() if part >= RIVAL)
    if one_way and foreign:
        as_well = tuple(dict.fromkeys((*as_well, *left)))
    much = best.select > max(limit.form, IMPERFECT) * floor
    needed = LEAST_SHARE_IF_FOREIGN if foreign else LEAST_SHARE
    # Much is left and none of it on its own coordinate: no form of this effect would take it away.
    if much and not left and not _rings_on(own, after):
        needed = LEAST_SHARE_IF_MUCH
    if best.share < needed:
        return Verdict("open", best, rivals, left, as_well)
    if rivals or as_well:
        return Verdict("cannot be told apart", best, rivals, left, as_well)
    incomplete = (bool(left) and not foreign) or best.select > limit.form * floor
    return Verdict("form incomplete" if incomplete else "effect", best, (), left)


def _rings_on(own: set[str], after: Sequence[Dependence]) -> bool:
    """Whether the spread that is left, if no force is, is strongest along an own coordinate.

    What yields and rings is wrong by its phase: no mean force is left of it, and much spread.
    """
    names = {c.rpartition(":")[2] for c in own}
    rings = located(after, VIBRATION, alike=LEADING)
    return any(c.rpartition(":")[2] in names for c in rings)


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
    near = last.kind != "unknown" and ratio <= IMPERFECT
    if first.kind == "open" and not (closed and (near or total_share >= LEAST_SHARE_IF_FOREIGN)):
        return Verdict("unknown", None, (first.accepted,), tuple(where) or last.coordinates)
    named = {r.accepted.candidate.family for r in rounds if r.accepted is not None}
    rivals = tuple(t for r in rounds for t in _rivals(r) if t.candidate.family not in named)
    as_well = tuple(dict.fromkeys(c for r in rounds if r.accepted for c in r.as_well))
    if rivals or as_well:
        kind = "cannot be told apart"
    elif ratio > limit.form:
        kind = "form incomplete"
    else:
        kind = first.kind if len(rounds) == 1 and first.kind != "open" else "effect"
    return Verdict(kind, first.accepted, rivals, last.coordinates, as_well)


def _rivals(one: Verdict) -> tuple[Trial, ...]:
    """Rivals of what a round accepted (the best candidate of an unknown is none)."""
    return one.rivals if one.accepted is not None else ()
