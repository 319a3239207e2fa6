"""Searches that end as they are told, and as much of a diagnosis as tells them."""

from types import SimpleNamespace as Some

from simpter_hybrid.identification.fitting.floor import Floors
from simpter_hybrid.identification.tracing.limits import Limits
from simpter_hybrid.identification.weighted_search import WeightedSearch, WeightedSearchResult


def diagnosis(declared, corrected=None, best=None, names=("drag",)):
    """As much of a diagnosis; `best` is the error of a candidate that may not be named."""
    predictor = Some(extended=lambda candidate: f"with {candidate.name}")
    base = Some(predictor=predictor, values={"a": 1.0}, select_error=declared, effects=())
    effects = [Some(name=name) for name in names]
    found = Some(predictor="found", values={"a": 2.0}, select_error=corrected, effects=effects)
    trial = Some(candidate=Some(name="wear"), fit=Some(values={"a": 3.0}), select_error=best)
    rounds = (Some(best=trial if best is not None else None),)
    return Some(refitted=base, corrected=found if corrected else base, rounds=rounds)


class Searching(WeightedSearch):
    """Searches that end as they are told."""

    def __init__(self, plain_first, *ends, tried=(), effort=None):
        predictor = "declared" if effort is None else Some(effort=effort)
        bench = Some(noise="noise", plain_first=plain_first, predictor=predictor)
        super().__init__(bench, tried, {}, {}, lambda text: None)
        object.__setattr__(self, "ends", list(ends))
        object.__setattr__(self, "by", [])

    def weighed_by(self, by, values, after=None):
        self.by.append(by)
        floors = Floors(1.0, 1.0, 1.0)
        split, limit = Some(select=None), Limits(form=1.2)
        return WeightedSearchResult(self.ends.pop(0), split, None, [], limit, 1.0, floors)


class Cut(Searching):
    """Searches each of which takes a step of simulated runs."""

    def weighed_by(self, by, values, after=None):
        self.bench.predictor.effort.add(1.0)
        return super().weighed_by(by, values, after)
