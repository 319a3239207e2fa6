"""What the runs held out say of a name: they are opened once, when all is decided.

They choose nothing.  But a correction that predicts them worse than the model did without it is
none: on data of others nine in ten of such names were of a null or of something else.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import inf
from typing import NamedTuple

from .fitting.floor import Floors
from .fitting.replay import Replay
from .fitting.residual import compared_only_where_predicted, predicted_errors
from .run_levels import RunLevels, differs
from .tracing.limits import OFF_NOISE, Limits
from .tracing.round import above_floor
from .tracing.rounds import SearchResult, before_last
from .tracing.traced import of_all_balances
from .tracing.verdict import without_effect

#: A correction is contradicted if it raises the error by this factor, half of a hundredth: what is
#: there lowers it.  A real wheel's rows were named for an effect that raised it by 1.7 %.
WORSE = 1.005
#: Where the values of runs (over their median) are this far apart, the difference of runs counts
#: for more than an effect does.
MUCH = 0.1
#: An effect that leaves less than this part of an error above the limit has mended more than noise.
MENDED = 0.5
#: Where nothing was named runs held out are no more than noise up to so many times the floor: of
#: robots 60 own nulls and nine of a tester ended at 1.05 at most, three lacks that the other runs
#: of his did not show at 1.07 to 1.14.
NOTHING = 1.06
#: Beyond so many times what the selecting runs leave, runs held out show something of their own.
AGAIN = 1.25


def carried_over(ratio: float) -> float:
    """Error, over the floor, up to which the runs held out show no more than the selecting ones.

    These have the error `ratio`, over theirs.
    """
    return max(OFF_NOISE, AGAIN * ratio)


class TakenBack(NamedTuple):
    """Effects that the runs held out contradict.

    Parameters
    ----------
    names : tuple of str
    select, held_out : tuple of float
        Errors of these runs without and with the effects, over the floor.  The error of the runs
        held out without them is that of the declared or of the refitted model, whichever is less.
    declared : bool
        Whether it is that of the declared model.
    """

    names: tuple[str, ...]
    select: tuple[float, float]
    held_out: tuple[float, float]
    declared: bool


class Harmful(NamedTuple):
    """A further effect with which the runs held out are predicted worse than without it alone.

    `without` and `with_it`: errors of these runs, over the floor.
    """

    name: str
    without: float
    with_it: float


def without_harmful(
    done: SearchResult,
    replays: Sequence[Replay],
    floors: Floors,
    limit: Limits,
    levels: Sequence[RunLevels] = (),
) -> tuple[SearchResult, tuple[Harmful, ...]]:
    """The search without last effects that raise the error of the runs held out.

    All effects together may lower it though one of them does harm: of a block that sticks and slips
    one by rest took 95 % of it away, and a second one, for which the selecting runs had fallen by
    an eighth, brought it back.

    Parameters
    ----------
    done : SearchResult
    replays : sequence of Replay
        The runs held out.
    floors, limit, levels
        As of `contradicted`.
    """
    found: list[Harmful] = []
    while len(done.corrected.effects) > 1 and not any(map(_differs_much, levels)):
        before = before_last(done, limit)
        if before is None:
            break
        models = before.corrected, done.corrected
        predicted = [m.predictor.predict(m.values, replays) for m in models]
        common: Sequence[Replay] = replays
        for one in predicted:
            common = compared_only_where_predicted(one, common)
        without, with_it = (predicted_errors(one, common)[0] for one in predicted)
        if with_it <= WORSE * without:
            break
        told = (error / floors.report for error in (without, with_it))
        found.append(Harmful(done.corrected.effects[-1].name, *told))
        done = before
    return done, tuple(found)


def contradicted(
    done: SearchResult,
    ladder: Mapping[str, float],
    floors: Floors,
    limit: Limits,
    levels: Sequence[RunLevels] = (),
) -> tuple[SearchResult, TakenBack | None]:
    """The diagnosis without effects with which the runs held out are predicted worse.

    What is said then is what would be if none had helped; and where these runs show no more than
    noise may be, that it cannot be told.  Where a parameter differs much from run to run, these
    have values of their own that nobody knows: they say nothing of what else is there.

    Parameters
    ----------
    done : SearchResult
    ladder : mapping of str to float
        ``declared``, ``refitted``, ``after``: errors on the runs held out, over the same rows.
    floors : Floors
    limit : Limits
    levels : sequence of RunLevels
        What differs from run to run.
    """
    known, effects = min(ladder["declared"], ladder["refitted"]), done.corrected.effects
    if not effects or ladder["after"] <= WORSE * known or any(map(_differs_much, levels)):
        return done, None
    ratio, accepted = done.refitted.select_error / done.floor, done.verdict.accepted
    above = above_floor(done.refitted, done.floor, floors.fit)  # as the search had judged it
    verdict = without_effect(of_all_balances(done.rounds[0].before), above, limit)
    fell = done.corrected.select_error / done.refitted.select_error
    if verdict.kind == "lack or noise" and ratio > limit.lack and fell < MENDED:
        verdict = replace(verdict, kind="unknown")
    if verdict.kind == "unknown" and known <= limit.lack * floors.report:
        verdict = replace(verdict, kind="lack or noise")
    if verdict.kind == "nothing missing" and known > carried_over(ratio) * floors.report:
        verdict = replace(verdict, kind="lack or noise")  # these show more than the others do
    verdict = replace(verdict, rivals=() if accepted is None else (accepted,))
    back = TakenBack(
        tuple(e.name for e in effects),
        (ratio, done.corrected.select_error / done.floor),
        (known / floors.report, ladder["after"] / floors.report),
        ladder["declared"] < ladder["refitted"],
    )
    return replace(done, corrected=done.refitted, verdict=verdict), back


def seen_held_out(
    done: SearchResult,
    ladder: Mapping[str, float],
    floors: Floors,
    limit: Limits,
    levels: Sequence[RunLevels] = (),
) -> SearchResult:
    """The diagnosis where the runs held out show more than noise, or than right forms leave.

    A form is incomplete then; and where nothing else showed a lack, it cannot be told whether there
    is one.  Parameters are those of `contradicted`: the lesser of the errors counts, for what a
    refit does not carry over is no lack.
    """
    kind, effects = done.verdict.kind, done.corrected.effects
    left = ladder["after"] if effects else min(ladder["declared"], ladder["refitted"])
    ratio = done.corrected.select_error / done.floor
    most = {
        "effect": limit.form,
        "nothing missing": max(limit.form, NOTHING, min(limit.lack, ratio)),
    }
    if not left / floors.report > most.get(kind, inf) or any(map(_differs_much, levels)):
        return done
    told = "form incomplete" if effects else "lack or noise"
    return replace(done, verdict=replace(done.verdict, kind=told))


def _differs_much(found: RunLevels) -> bool:
    times = [level for _, level in found.levels]
    return differs(found) and max(times) - min(times) > MUCH
