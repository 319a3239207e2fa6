"""What is said of a model that goes another way than the record."""

from __future__ import annotations

from ..held_out_predictions import HeldOutPredictions
from ..pace import other_pace


def pace_sentence(told: HeldOutPredictions) -> str:
    """Sentence on a corrected model that goes another way than the record; "" if it does not."""
    if (found := other_pace(told)) is None:
        return ""
    model = "corrected" if told.changed else "refitted"
    return (
        f"Is the inertia, or the drive's constant, far off? In {found.windows} windows of the "
        f"runs held out the {model} model goes {100.0 * found.pace:.0f} % of the way of the "
        f"{found.channel} (+- {200.0 * found.error:.0f} %). Errors of windows' first speeds "
        "go either way, and do not do that, but half of a straight line counts as one: "
        "the error told is too small, and the numbers found are not to be trusted. Log the "
        "speed as well."
    )
