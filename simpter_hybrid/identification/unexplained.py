"""What a search leaves unexplained: on what it depends, and a curve over that."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from math import inf, isfinite

import numpy as np

from .empirical import PIECES, TRIED, Empirical, best_probes, curve_of, empirical_term, settles
from .empirical_terms import OF_ONE, over_channel, pieces_of, terms_over
from .fitting.fitted_model import Model, Split, refitted
from .fitting.search import try_candidates
from .going_with import ORDER, goes_with
from .repeating import WHERE, repeating
from .rigs.effect_candidate import EffectCandidate
from .rigs.following import known_levels
from .run_levels import RunLevels, differs
from .tracing.conclusion import NO_FORCE
from .tracing.limits import IMPERFECT
from .tracing.locating import LAST
from .tracing.named import balance_of, coordinate_of
from .tracing.rivals import CLEARLY_WORSE, FAR_WORSE, LEAST_GAIN, RIVAL
from .tracing.rounds import SearchResult
from .tracing.slow_state import RUN
from .tracing.trace import Trace
from .tracing.verdict import FAR_ABOVE, LACKING, LEAST_SHARE, Verdict
from .weighted_search import WeightedSearchResult

#: Verdicts after which a curve is fitted over what is left.
UNEXPLAINED = ("unknown", "form incomplete")
#: A refit by more than so many tolerances went far; reports tell it too.
FAR = 2.0


def with_curve_over_rest(
    found: WeightedSearchResult, levels: Sequence[RunLevels], say: Callable[[str], None]
) -> tuple[SearchResult, Empirical | None]:
    """The diagnosis with the coordinates on which the rest depends, and a curve over one of them.

    Where the search has located nothing and much is left, curves over all coordinates are asked;
    and where a curve over what it has located takes next to nothing away: a refit that went far has
    bent the residual along something else.  So they are where that curve leaves much: residual
    forces of a motion that only positions show are smeared, and another curve may do far better.
    What differs from run to run along with a logged channel is asked for a curve over that, beside
    named effects as well.
    Effects that leave much are no answer where one curve leaves far less, and not told apart from
    it where it does about as well along something on which the rest still depends.
    """
    done = found.search
    beside = _beside_what_was_named(found, say)
    if beside is not None and _outdone(done, *beside):
        unknown = Verdict("unknown", None, (done.verdict.accepted,), beside[0])  # type: ignore[arg-type]
        return replace(done, corrected=done.refitted, verdict=unknown), beside[1]
    done, term = _over_rest(found, levels, say)
    if beside is not None:
        done = replace(done, verdict=_not_told_apart(found, beside, done.verdict))
    return done, term


def _over_rest(
    found: WeightedSearchResult, levels: Sequence[RunLevels], say: Callable[[str], None]
) -> tuple[SearchResult, Empirical | None]:
    """The diagnosis with the coordinates on which the rest depends, and a curve over one of them.

    What was named stays.
    """
    done = found.search
    verdict, model = done.verdict, done.corrected
    much = model.select_error > max(found.limit.form, IMPERFECT) * done.floor
    if levels and (along := _where_runs_differ(done, levels)):
        channels = [c for c in goes_with(levels[0]) if c != ORDER]
        if channels and (term := over_channels(channels, along, found, say)):
            return done, term
    if verdict.coordinates:
        asked = verdict.kind in UNEXPLAINED
    else:
        asked = much and verdict.kind in (*UNEXPLAINED, *LACKING)
    if not asked:
        return done, None
    say("fitting a curve over what is left")
    traces = found.tracer(model.predictor, model.values, found.split.fit)
    known, left = None, inf
    if verdict.coordinates:
        known = empirical_term(model, verdict.coordinates, traces, found.split, done.floor)
        if known is not None and known.trial.share >= LEAST_SHARE:
            left = known.trial.select_error
        short = left > IMPERFECT * done.floor if isfinite(left) else _went_far(model)
        further = verdict.kind == "unknown" and much and short
        if not further or any(map(_in_last, verdict.coordinates)):
            return _settled(found, known), known
    where, term = asked_by_curves(model, traces, found.split, done.floor)
    open_to_it = term is None and not verdict.coordinates and WHERE not in _own(model)
    if open_to_it and repeating(found.tracer, found.split):
        return replace(done, verdict=_unknown(verdict, (WHERE,))), None
    if term is None or left <= CLEARLY_WORSE * term.trial.select_error:
        return _settled(found, known), known
    return replace(done, verdict=_unknown(verdict, where)), term


def _settled(found: WeightedSearchResult, known: Empirical | None) -> SearchResult:
    """The diagnosis in which a lack depends on what a curve over it takes away, if that is all.

    What is missing moves all that moves: of two slides of which one pulled a cable tight, its
    position was the last of five coordinates, and a curve over it alone left noise.  What is told
    of breakaways, and of the same coordinate in the other balance of a rotor, stays.
    """
    done, verdict = found.search, found.search.verdict
    most = found.limit.form * done.floor
    if known is None or verdict.kind != "unknown":
        return done
    if not settles(known, done.corrected.select_error, most):
        return done
    own, name = set(known.alike), coordinate_of(known.coordinate)
    kept = (
        c for c in verdict.coordinates
        if c in own or balance_of(c) in NO_FORCE
        or (coordinate_of(c) == name and not balance_of(c).startswith("joint"))
    )  # fmt: skip
    where = tuple(dict.fromkeys((known.coordinate, *kept)))
    return replace(done, verdict=replace(verdict, coordinates=where))


def _where_runs_differ(done: SearchResult, levels: Sequence[RunLevels]) -> str:
    """A coordinate of the balance in which runs differ; "" if what differs is no part of a verdict.

    Beside effects that were named the verdict does not say so: there it is one of theirs.
    """
    if any(coordinate_of(c) == RUN for c in done.verdict.coordinates):
        return done.verdict.coordinates[0]
    if done.verdict.accepted is None or not all(map(differs, levels)):
        return ""
    own = (c for e in done.corrected.effects for c in e.coordinates)
    return next((c for c in own if balance_of(c) in OF_ONE), "")


def _unknown(verdict: Verdict, where: Sequence[str]) -> Verdict:
    """The verdict, where it turns out on what a lack depends."""
    kind = "unknown" if verdict.kind in LACKING else verdict.kind
    return replace(verdict, kind=kind, coordinates=tuple(where))


def _beside_what_was_named(
    found: WeightedSearchResult, say: Callable[[str], None]
) -> tuple[tuple[str, ...], Empirical] | None:
    """The curve that explains most alone, in place of all that was named; None if that is enough.

    With it the coordinates along which a curve does so.
    """
    done = found.search
    base, model = done.refitted, done.corrected
    much = model.select_error > max(found.limit.form, IMPERFECT) * done.floor
    if done.verdict.accepted is None or not much:
        return None
    say("fitting curves beside what was named")
    traces = found.tracer(base.predictor, base.values, found.split.fit)
    where, term = asked_by_curves(base, traces, found.split, done.floor)
    return None if term is None else (where, term)


def _own(model: Model) -> set[str]:
    """Coordinates of the effects of a model."""
    return {c for effect in model.effects for c in effect.coordinates}


def _outdone(done: SearchResult, where: Sequence[str], term: Empirical) -> bool:
    """Whether a curve does more than all that was named.

    A curve along an own coordinate of an effect may be a better form of it: that has to leave half
    of what it leaves.  A curve over a pendulum's way since a reversal left 1.02 times the floor
    where a ripple and Stribeck friction had left 1.38.
    """
    least = FAR_WORSE if _own(done.corrected) & set(where) else CLEARLY_WORSE
    return done.corrected.select_error > least * term.trial.select_error


def _not_told_apart(
    found: WeightedSearchResult, beside: tuple[tuple[str, ...], Empirical], verdict: Verdict
) -> Verdict:
    """The verdict where far too much is left, on something along which a curve did about as well.

    A slide with more friction after its reversals was friction that falls with speed, at 33 times
    the floor, with the way since a reversal left; a curve over that alone left 37 times it.
    """
    (along, *_), term = beside
    model = found.search.corrected
    if model.select_error <= FAR_ABOVE * found.search.floor:
        return verdict
    if term.trial.select_error > CLEARLY_WORSE * model.select_error:
        return verdict
    if along not in verdict.coordinates or along in (*_own(model), *verdict.as_well):
        return verdict
    as_well = (*verdict.as_well, along)
    return replace(verdict, kind="cannot be told apart", as_well=as_well)


def _went_far(model: Model) -> bool:
    """Whether a declared parameter was refitted by more than `FAR` times its tolerance."""
    declared = (p for p in model.predictor.parameters if np.isfinite(p.tolerance))
    return any(abs(model.values[p.name] - p.value) > FAR * p.tolerance for p in declared)


def _in_last(coordinate: str) -> bool:
    """Whether a dependence is one of `LAST`, over which no curve can be drawn."""
    return bool(LAST.keys() & set(coordinate.split(":")))


def over_channels(
    channels: Sequence[str], where: str, found: WeightedSearchResult, say: Callable[[str], None]
) -> Empirical | None:
    """A curve of friction over a channel, with common values in all runs; None if none tells.

    Nor where there are several joints: nothing says whose friction it is.
    """
    if (balance := balance_of(where)) not in OF_ONE:
        return None
    say(f"fitting a curve over {' and '.join(channels)}")
    fit, select = ([replace(r, own={}) for r in rs] for rs in (found.split.fit, found.split.select))
    split, model = replace(found.split, fit=fit, select=select), found.search.corrected
    base = refitted(model.predictor, split, model.effects, model.values, model.unit)
    known = {c: known_levels(fit, c) for c in channels}
    terms = {c: over_channel(c, v) for c, v in known.items() if v.size and np.ptp(v) > 0.0}
    trials = try_candidates(base, list(terms.values()), split, found.search.floor)
    best = min(trials, key=lambda t: t.select_error, default=None)
    if best is None or best.gain < LEAST_GAIN:
        return None
    (channel,) = (c for c, term in terms.items() if term.name == best.candidate.name)
    return curve_of(best, f"{balance}:{channel}", base, split)


def asked_by_curves(
    base: Model, traces: Mapping[str, Sequence[Trace]], split: Split, floor: float
) -> tuple[tuple[str, ...], Empirical | None]:
    """Coordinates on which a lack depends by fitted curves, where no residual force shows it.

    Where positions are noisy and no force is measured, the residual force is noise from row to row,
    in which what happens at one place is lost; curves fitted to whole courses show it.

    Returns
    -------
    tuple of str
        ``balance:coordinate``, the one whose curve explains most of the lack on the selecting runs
        first, then those whose curves do nearly as well; none where no curve explains what an
        effect would have to.
    Empirical or None
        The first one's curve.
    """
    along: dict[str, str] = {}
    whole: dict[str, EffectCandidate] = {}
    pieces: list[EffectCandidate] = []
    for balance, told in traces.items():
        for coordinate in (f"{balance}:{name}" for name in (told[0].coordinates if told else ())):
            parts = pieces_of(coordinate, traces)
            for term in (*terms_over(coordinate, traces), *parts):
                along.setdefault(term.name, coordinate)
                if term not in parts:
                    whole.setdefault(term.name, term)
            pieces += parts
    probes = best_probes(base, list(whole.values()), split, TRIED)
    probes += best_probes(base, pieces, split, PIECES)
    trials = try_candidates(base, (), split, floor, probes=probes)
    best = min(trials, key=lambda t: t.select_error, default=None)
    if best is None or best.gain < LEAST_GAIN or best.share < LEAST_SHARE:
        return (), None
    alike = (
        t for t in trials
        if t.share >= RIVAL * best.share and t.select_error <= CLEARLY_WORSE * best.select_error
    )  # fmt: skip
    where = tuple(dict.fromkeys(along[t.candidate.name] for t in alike))
    return where, curve_of(best, where[0], base, split)
