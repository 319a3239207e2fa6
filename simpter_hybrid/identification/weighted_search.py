"""The search for effects with residuals as they deserve to count: scaled, and weighed."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import islice
from typing import Any

from .fitting.effort import effort_of
from .fitting.fitted_model import Split, refitted
from .fitting.floor import Floors, floors_of
from .fitting.masks import without_jumps
from .fitting.memory import Memory
from .fitting.repeats import Repeated, names_of_repetitions, repeated_over
from .fitting.replay import Replay
from .fitting.replicates import merged, replicates
from .fitting.residual import errors_by_experiment
from .next_search import begun, better_model
from .rigs.bench import Bench
from .rigs.effect_candidate import EffectCandidate
from .rigs.free_start import started
from .tracing.limits import REPEATED, Limits, known_by_repetition
from .tracing.rivals import LEAST_GAIN
from .tracing.rounds import SearchResult, search_effects
from .tracing.traced import Tracer
from .tracing.verdict import LACKING


@dataclass(frozen=True)
class WeightedSearchResult:
    """A diagnosis and what it used: runs (`fitted`: before repetitions were averaged) and tracer.

    `noise`: floor of the selecting runs without what repeated runs differ by.  `repeated`: names of
    runs that count as one driven again, where these have raised the floors.  `unfinished`: whether
    a further search was begun, which the effort ended, and is not used.
    """

    search: SearchResult
    split: Split
    tracer: Tracer
    fitted: list[Replay]
    limit: Limits
    noise: float
    floors: Floors
    repeated: tuple[tuple[str, ...], ...] = ()
    unfinished: bool = False


#: Most searches.
SEARCHES = 3
#: Candidates by which repeated runs are compared, beside what was found.
ASKED = 3


@dataclass(frozen=True)
class WeightedSearch:
    """The search on one rig, by whatever model its residuals are weighed.

    Parameters
    ----------
    bench : Bench
    tried : tuple of EffectCandidate
    parts : mapping of str to list of Replay
        ``fit``, ``select``, ``report``, as `scaled` makes them.
    start : mapping of str to float
        Where the refit of the declared parameters begins.
    say : callable
        Told what is being done.
    """

    bench: Bench
    tried: tuple[EffectCandidate, ...]
    parts: Mapping[str, list[Replay]]
    start: Mapping[str, float]
    say: Callable[[str], None]

    def settled(self, values: Mapping[str, float]) -> WeightedSearchResult:
        """Search, and again with residuals weighed by what was found, if that is far better.

        Where the declared model sticks and the device moves, most of a lack goes along curves of
        noise, and fits end in valleys: `Bench.plain_first` searches once without them, and what
        that found stays if the search with them finds something else, not at the floor, and ends
        above it.  It also does if the effort is used up by then, or before the other has found
        anything.
        """
        names: tuple[str, ...] = ()
        by, plain = self.bench.predictor, None
        effort = effort_of(by)
        if self.bench.noise is not None and self.bench.plain_first:
            plain = self.weighed_by(None, values)
            if effort.used_up:
                return plain
            names, by, values = better_model(plain.search, far=1.0)
            self.say(f"once more, weighed for noise of inputs by {_called(names)}")
        found = self.weighed_by(by, values, None if plain is None else plain.search)
        if plain is not None and effort.used_up and _to_be_found(found):
            return replace(plain, unfinished=True)
        weighed = [set(), self._families(names)]
        unnamed = plain is not None and bool(names) and not plain.search.corrected.effects
        while self.bench.noise is not None and len(weighed) <= SEARCHES and not effort.used_up:
            names, by, values = better_model(found.search)
            # Weighed by a candidate that nobody named, and nothing named: by the model itself.
            itself = unnamed and not names and not found.search.corrected.effects
            if self._families(names) in weighed and not itself:
                break
            unnamed = False
            weighed.append(self._families(names))
            self.say(f"once more, weighed by {_called(names)}: what weighed was far off")
            again = self.weighed_by(by, values, found.search)
            if effort.used_up:  # what came to its end is better than what was cut short
                found = replace(found, unfinished=True)
                break
            found = again
        if plain is not None and _better(plain, found):
            return replace(plain, unfinished=found.unfinished)
        return found

    def _families(self, names: Sequence[str]) -> set[str]:
        """Families of the effects named: noise does much the same to forms of one family."""
        known = {c.name: c.family for c in self.tried}
        return {known.get(name, name) for name in names}

    def weighed_by(
        self, by: Any, values: Mapping[str, float], after: SearchResult | None = None
    ) -> WeightedSearchResult:
        """Search with residuals weighed by the predictor `by` at `values`; None: by noise alone.

        What an earlier search has fitted is begun from there as well: under other weights one
        linear step may promise nothing of the effect that was found.
        """
        tried = self.tried if after is None else begun(self.tried, after)
        declared: Any = self.bench.predictor
        calm, split = self._weighed(by, values)
        base = refitted(declared, split, start=self.start)
        if by is declared and any(r.start_free for r in split.fit):
            # A start by a model not yet fitted makes up for what is wrong with it.
            calm, split = self._weighed(by, base.values)
            base = refitted(declared, split, start=base.values)
            values = base.values
        floors, limit = self._floors(by, values, calm, split)

        def progress(name: str, gain: float) -> None:
            takes = f"takes {100 * gain:.1f} % of the error away" if gain > 0.0 else "no better"
            self.say(f"tried {name} of {len(tried)} candidates: {takes}")

        tracer, memory = self.bench.tracer(calm["fit"]), Memory()

        def searched(floors: Floors, limit: Limits) -> SearchResult:
            ratio = base.select_error / floors.select
            self.say(f"refitted: {ratio:.3f} times the floor of noise on the selecting runs")
            return search_effects(
                base, tried, split, tracer, floors.select, progress, limit=limit,
                fit_floor=floors.fit, memory=memory,
            )  # fmt: skip

        noise = floors.select
        repeated: tuple[tuple[str, ...], ...] = ()
        done = searched(floors, limit)
        again = None if limit is REPEATED else _repeated(done, calm, floors)
        if again is not None:
            times, before = again.times, limit
            limit = known_by_repetition(limit, times.select, again.sure)
            tighter = limit.lack < before.lack or limit.form < before.form
            tighter = tighter or not done.corrected.effects  # less is asked of a first one now
            raised = any(t > 1.0 for t in times)
            if raised:
                repeated = names_of_repetitions([*calm["fit"], *calm["select"]])
            floors = Floors(*(f * max(1.0, t) for f, t in zip(floors, times, strict=True)))
            if raised or tighter or done.verdict.kind in LACKING:
                self.say("once more, with what repeated runs differ by as the floor")
                done = searched(floors, limit)
        return WeightedSearchResult(
            done, split, tracer, calm["fit"], limit, noise, floors, repeated
        )

    def _weighed(
        self, by: Any, values: Mapping[str, float]
    ) -> tuple[dict[str, list[Replay]], Split]:
        """All parts, begun and weighed by a model, and as they are fitted."""
        runs = dict(self.parts)
        if by is not None:
            runs = {k: started(by.simulated, values, v) for k, v in runs.items()}
        # All at once: whoever draws noise draws it for the whole recording.
        every = iter(self._calm(by, values, [run for some in runs.values() for run in some]))
        calm = {part: list(islice(every, len(some))) for part, some in runs.items()}
        return calm, Split(merged(calm["fit"]), calm["select"], calm["report"])

    def _calm(self, by: Any, values: Mapping[str, float], replays: Sequence[Replay]):
        """Replays without the samples around jumps, or weighed as noisy inputs have it."""
        if self.bench.noise is not None and by is None:
            return list(replays)
        if self.bench.noise is not None:
            return replace(self.bench.noise, predictor=by).weighed(values, replays)
        if not self.bench.jumps:
            return list(replays)
        predicted = by.predict(values, replays)[self.bench.jumps]
        return without_jumps(replays, predicted, self.bench.jumps)

    def _floors(
        self, by: Any, values: Mapping[str, float], calm: Mapping[str, list[Replay]], split: Split
    ) -> tuple[Floors, Limits]:
        """Floors by replicates or, of what has none, by the noise as stated or estimated.

        And up to how many times that is noise: where noise of inputs is allowed for, simulated
        draws of it make a better estimate than any other of single runs.
        """
        limit = REPEATED if replicates(self.parts["fit"]) else self.bench.limits
        if self.bench.noise is not None and by is not None:
            allowed = replace(self.bench.noise, predictor=by)
            return Floors(**allowed.floors(values, calm)), limit
        # The fitted runs as errors are taken of them: merged ones count once.
        parts = {"fit": split.fit, "select": split.select, "report": split.report}
        return floors_of(calm["fit"], parts), limit


def _to_be_found(found: WeightedSearchResult) -> bool:
    """Whether a search has found no effect, and more than noise is left."""
    done = found.search.corrected
    return not done.effects and done.select_error > found.limit.clean * found.floors.select


def _better(plain: WeightedSearchResult, found: WeightedSearchResult) -> bool:
    """Whether the plain search found other effects with a lower error on the runs as weighed.

    False where the weighed search leaves no more than noise: a plain one adds patches to that.
    """
    first, other = plain.search.corrected, found.search.corrected
    names = [sorted(e.name for e in model.effects) for model in (first, other)]
    noise = found.limit.form if other.effects else found.limit.clean
    right = other.select_error <= noise * found.floors.select
    if not first.effects or names[0] == names[1] or right:
        return False
    error, _ = errors_by_experiment(first.predictor, first.values, found.split.select)
    return error < (1 - LEAST_GAIN) * other.select_error


def _repeated(
    done: SearchResult, runs: Mapping[str, Sequence[Replay]], floors: Floors
) -> Repeated | None:
    """What repeated runs differ by, over these floors, by whichever model makes that least.

    By a model that lacks something small noise makes one run stick where the other moves on.
    """
    models = [(m.predictor, m.values) for m in (done.refitted, done.corrected)]
    best = sorted(done.rounds[0].trials, key=lambda t: t.select_error)[:ASKED]
    models += [(done.refitted.predictor.extended(t.candidate), t.fit.values) for t in best]
    return repeated_over(floors, models, runs)


def _called(names: Sequence[str]) -> str:
    return f"the model with {' and '.join(names)}" if names else "the refitted model"
