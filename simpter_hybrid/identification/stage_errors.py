"""Errors of each stage of a diagnosis, declared to corrected, on the runs held out."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from .empirical import Empirical
from .fitting.floor import replicate_floor
from .fitting.replay import Replay
from .fitting.residual import channel_errors, compared_only_where_predicted, predicted_errors
from .rigs.free_start import started
from .tracing.rounds import SearchResult
from .weighted_search import WeightedSearchResult


@dataclass(frozen=True)
class StageErrors:
    """Errors on the runs held out: ``declared``, ``refitted``, ``after``, ``empirical``, ``floor``.

    Parameters
    ----------
    of_channels : mapping of str to mapping of str to float
        Stage -> channel -> error [SI].
    of_all : mapping of str to float
        Stage -> error over all channels [standard deviations].
    of_experiments : mapping of str to mapping of str to float
        Stage -> experiment -> error [standard deviations], but for the floor.
    alike : mapping of str to float
        As `of_all`, over the rows of which all stages tell something.
    """

    of_channels: Mapping[str, Any]
    of_all: Mapping[str, float]
    of_experiments: Mapping[str, Any]
    alike: Mapping[str, float]

    def without_after(self) -> StageErrors:
        """As they are once what was found is taken back, with any curve over the rest."""

        def kept(stages: Mapping[str, Any]) -> dict[str, Any]:
            rest = {k: v for k, v in stages.items() if k != "empirical"}
            return {**rest, "after": stages["refitted"]}

        told = (self.of_channels, self.of_all, self.of_experiments, self.alike)
        return StageErrors(*map(kept, told))


def errors_of_stages(
    done: SearchResult,
    term: Empirical | None,
    found: WeightedSearchResult,
) -> StageErrors:
    """Errors of all models on the runs held out.

    Parameters
    ----------
    done : SearchResult
        With the refitted and the corrected model.
    term : Empirical or None
        A curve over what is left.
    found : WeightedSearchResult
        Whose runs and floors they are.
    """
    nominal = {p.name: p.value for p in done.refitted.predictor.parameters}
    models: dict[str, tuple[Any, Mapping[str, float]]] = {
        "declared": (done.refitted.predictor, nominal),
        "refitted": (done.refitted.predictor, done.refitted.values),
        "after": (done.corrected.predictor, done.corrected.values),
    }
    if term is not None:
        models["empirical"] = (term.model.predictor, term.model.values)
    errors, ladder, apart, told_by = {}, {}, {}, {}
    held_out = found.split.report
    common: Sequence[Replay] = held_out
    for name, (predictor, values) in models.items():
        runs = started(predictor.simulated, values, held_out)
        told_by[name] = predicted = predictor.simulated(values, runs)
        errors[name] = channel_errors(predicted, runs)
        ladder[name], apart[name] = predicted_errors(predicted, runs)
        common = compared_only_where_predicted(predicted, common)
    errors["floor"] = replicate_floor(found.fitted)
    ladder["floor"] = found.floors.report
    alike = {name: predicted_errors(one, common)[0] for name, one in told_by.items()}
    return StageErrors(errors, ladder, apart, alike)
