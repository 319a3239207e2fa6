"""What coordinates mean where nothing ever turns round."""

from __future__ import annotations

from ..result import Diagnosis
from ..tracing.named import REVERSAL, coordinate_of
from ..tracing.traced import goes_one_way

#: Coordinates that a record without reversals gives another meaning, in words.
MEANS = {
    "direction": "direction tells motion from rest",
    REVERSAL: "displacement since reversal is the way since a run began",
}


def one_direction_sentence(found: Diagnosis) -> str:
    """Sentence on what a dependence means in runs that all go one way; "" in others.

    A cart that only went forward was said to depend on direction.
    """
    told = {coordinate_of(c) for c in found.search.verdict.coordinates}
    means = [words for name, words in MEANS.items() if name in told]
    if not means or found.tracer is None:
        return ""
    model = found.search.refitted
    traces = found.tracer(model.predictor, model.values, found.split.fit)
    if not goes_one_way(traces):
        return ""
    return f"All motion in the fitted runs goes one way: there {' and '.join(means)}."
