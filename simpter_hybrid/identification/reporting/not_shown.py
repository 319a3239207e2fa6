"""What a name does not carry: a size that data do not tell, runs held out that it leaves far."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ..fitting.predictor import Candidate
from ..held_out_gains import HeldOutGain
from ..result import Diagnosis
from ..run_levels import differs
from ..tracing.limits import IMPERFECT
from ..tracing.rivals import LEAST_FURTHER
from .held_out_sentences import SPOILT, held_out
from .kinds_of_runs import far_ones, own_errors
from .size_intervals import sizes_may_be_zero

#: Repeated runs of one kind are named if they differ so many times as much as those of most kinds
#: (of own recordings without such events 1.2 at most), of so many kinds at least.
UNSTEADY, KINDS = 1.5, 3
#: Verdicts that name an effect plainly.
NAMED = ("effect", "form incomplete")
#: Numbers that are correlated by more than this make up for one another.
TRADED = 0.9
#: So many candidates that do better on the runs held out are told.
SAID = 3


def unsized_sentence(
    found: Diagnosis,
    parameters: Sequence[Mapping[str, Any]],
    gains: Sequence[Sequence[HeldOutGain]] = (),
) -> str:
    """Which effects that were named have sizes that may all be zero; "" where none is such.

    What surely makes the runs held out better is of some size, however wide its interval: of what
    sits in the instants of a few breakaways a derivative tells little, and several sizes may make
    up for one another.  Of these it is said that none is known by itself, and of a single one how
    little is known of it.  Beside rivals the runs held out say no more than that one of them is
    there, and nothing of other runs where these differ too much.

    Parameters
    ----------
    found : Diagnosis
    parameters : sequence of mapping
        Rows as of `parameter_rows`.
    gains : sequence of sequence of HeldOutGain
        Of the candidates of each round.
    """
    told = {p["name"]: p for p in parameters}
    named = _of_named(found, gains)
    sure = {gain.name for gain in named if gain.low_here > 0.0}
    here = {gain.name for gain in named if gain.low <= 0.0}
    wide = [
        e for e in found.search.corrected.effects
        if e.sizes and sizes_may_be_zero(e, told)
    ]  # fmt: skip
    unsized = [e.listed_as for e in wide if e.name not in sure]
    traded = [
        e.name for e in wide
        if e.name in sure and len(e.sizes) > 1
        and all(abs(told[n].get("largest_correlation", 0.0)) > TRADED for n in e.sizes)
    ]  # fmt: skip
    single = [e for e in wide if e.name in sure and len(e.sizes) == 1]
    alone = [e.listed_as for e in single if e.name not in here]
    only_here = [e.listed_as for e in single if e.name in here]
    said = []
    if unsized:
        said.append(
            f"These data do not tell how large {' and '.join(unsized)} would be: no 95 % interval "
            "leaves zero out. Take what is named for a hint."
        )
    if traded:
        said.append(
            f"Of the sizes of {' and '.join(traded)} no 95 % interval leaves zero out: what they "
            "do lowers the error of the runs held out, but other numbers make up for each, and "
            "none is known by itself."
        )
    if alone:
        names = " and ".join(alone)
        there, much = f"That there is {names}", "of it"
        if found.search.verdict.kind not in NAMED:
            there, much = "That something of this set is there", f"{names} there would be"
        said.append(
            f"{there} the runs held out say; how much {much}, these data hardly tell: the 95 % "
            "interval has zero in it."
        )
    if only_here:
        names = " and ".join(only_here)
        said.append(
            f"These runs held out are predicted better with {names}, but another such run may show "
            "nothing of it, and these data hardly tell how much of it there is: both 95 % "
            "intervals have zero in them."
        )
    return " ".join(said)


def unborne_sentence(found: Diagnosis, gains: Sequence[Sequence[HeldOutGain]] = ()) -> str:
    """Which effects that were named may do nothing on the runs held out; "" if none.

    `gains`: of the candidates of each round.
    """
    if found.search.verdict.kind not in NAMED:
        return ""
    kept = {e.name for e in found.search.corrected.effects}
    doubtful = [
        f"{gain.name} takes {round(100 * gain.gain)} % of their error away, {_within(gain)}"
        for gain in _of_named(found, gains)
        if gain.name in kept and gain.low <= 0.0 and gain.low_here <= 0.0
    ]
    if not doubtful:
        return ""
    return (
        "On the runs held out it is not sure that what was named does any good "
        f"({'; '.join(doubtful)})."
    )


def _of_named(
    found: Diagnosis, gains: Sequence[Sequence[HeldOutGain]]
) -> list[HeldOutGain]:  # fmt: skip
    """What the effects that the search named at last do on the runs held out.

    What a round had taken first may have given its place to another (`tracing/revision.py`).
    """
    return [
        gain
        for done, each in zip(found.search.rounds, gains, strict=False)
        for gain in each
        if (named := done.verdict.accepted) is not None and gain.name == named.candidate.name
    ]


def _within(gain: HeldOutGain) -> str:
    """Words on the interval of a gain."""
    if not gain.has_interval:
        return "and they tell no interval of it"
    return f"95 %: {round(100 * gain.low)} to {round(100 * gain.high)} %"


def outdone_sentence(
    found: Diagnosis, gains: Sequence[Sequence[HeldOutGain]] = ()
) -> str:  # fmt: skip
    """Which candidates do surely better than what was named on the runs held out; "" if none.

    Nothing is chosen by that: these runs are opened when all is decided.  Asked where what was
    named leaves more of them than noise, of the round that ended with the corrected model, and of
    other kinds of effects.

    Parameters
    ----------
    found : Diagnosis
    gains : sequence of sequence of HeldOutGain
        Of the candidates of each round.
    """
    effects = [e.name for e in found.search.corrected.effects]
    if not effects or held_out(found) <= IMPERFECT:
        return ""
    for done, each in zip(found.search.rounds, gains, strict=False):
        best, base = done.verdict.accepted, done.base
        if best is None or base is None:
            continue
        if [*(e.name for e in base.effects), best.candidate.name] != effects:
            continue
        alike = {t.candidate.name for t in done.trials if _is_form(t.candidate, best.candidate)}
        better = [
            g for g in each
            if g.surely_beyond > 0.0 and g.beyond >= LEAST_FURTHER and g.name not in alike
        ]  # fmt: skip
        better = sorted(better, key=lambda g: -g.beyond)[:SAID]
        if better:
            told = ", ".join(f"{g.name} {round(100 * g.beyond)} %" for g in better)
            return (
                f"On the runs held out others leave less than {best.candidate.name} ({told} less): "
                f"that it is {best.candidate.name}, the runs that select alone say."
            )
    return ""


def _is_form(one: Candidate, other: Candidate) -> bool:
    """Whether the first candidate is of the other's kind, contains it or is contained.

    A declared value that an effect contains is none: that it alone leaves less is worth telling.
    """
    within = one.name in other.contains and not one.declared
    return one.family == other.family or within or other.name in one.contains


def uneven_sentence(
    found: Diagnosis,
    errors: Mapping[str, Mapping[str, float]],
    runs: Mapping[str, Sequence[Mapping[str, Any]]],
) -> str:
    """Which runs held out the corrected model leaves far worse than others of their kind; else "".

    Of a kind of which none fits or selects: than those that select.

    Parameters
    ----------
    found : Diagnosis
    errors : mapping of str to mapping of str to float
        As of `errors_of_experiments`: what repeated runs of one kind differ by is no lack of it.
    runs : mapping of str to sequence of mapping
        As of `errors_of_runs`.
    """
    far, own = far_ones(found, errors, runs), own_errors(errors, runs)
    said = []
    if known := {n: times for n, times in far.items() if n in own}:
        told = (f"{n} {t:.3g} times the floor, against {own[n]:.3g}" for n, t in known.items())
        said.append(
            "Of the runs held out some are far worse than those of their kind that fit or select "
            f"({', '.join(told)}): {_why(found, errors, tuple(known))}."
        )
    if new := {n: times for n, times in far.items() if n not in own}:
        listed = ", ".join(f"{name} {times:.3g}" for name, times in new.items())
        select = found.search.corrected.select_error / found.search.floor
        said.append(
            f"Of the runs held out some are far worse than those that select ({listed} times the "
            f"floor, against {select:.3g}): {_why(found, errors, tuple(new))}; let some of their "
            "kind fit and select as well."
        )
    return " ".join(said)


def _why(
    found: Diagnosis, errors: Mapping[str, Mapping[str, float]], far: Sequence[str]
) -> str:  # fmt: skip
    """Words on why runs held out may be far worse."""
    if found.levels and all(map(differs, found.levels)):
        own = " and ".join(levels.parameter for levels in found.levels)
        return f"{own} may be another in them too, for which they have the common value here"
    if told := _told_without(errors, far):
        what = "what was found" if found.search.corrected.effects else "the refit"
        return f"{told}, so {what} does not carry over there"
    return "what they do differently nothing here explains"


def _told_without(errors: Mapping[str, Mapping[str, float]], far: Sequence[str]) -> str:
    """Words on runs that the model told far better before anything was found; "" without any."""
    said = []
    for name in far:
        e = errors[name]
        stage = min(("declared", "refitted"), key=lambda stage: e.get(stage, np.inf))
        if SPOILT * (before := e.get(stage, np.inf)) < e["after"]:
            said.append(f"the {stage} model leaves {before / e.get('floor', 1.0):.3g} on {name}")
    return " and ".join(said)


def unsteady_sentence(floors: Mapping[str, float]) -> str:
    """Which repeated runs differ far more than most: what comes now and then is in the floor.

    Parameters
    ----------
    floors : mapping of str to float
        Experiment -> what its repeated runs differ by, in any unit.
    """
    if len(floors) < KINDS:
        return ""
    usual = float(np.median(list(floors.values())))
    if usual == 0.0:
        return ""
    named = {n: f / usual for n, f in floors.items() if f > UNSTEADY * usual}
    if not named:
        return ""
    runs = ", ".join(f"{name} {times:.1f}" for name, times in named.items())
    return (
        f"Repeated runs of some kinds differ far more than those of most ({runs} times as much): "
        "what comes in one and not in the other is in the floor, and nothing here looks for it."
    )
