"""That a force repeats along an axis, where recorded accelerations alone show it."""

from __future__ import annotations

import math

from ...units import is_unit
from ..repeating import WHERE, repeating
from ..result import Diagnosis
from ..tracing.verdict import LACKING


def repeating_sentence(found: Diagnosis) -> str:
    """Sentence on how often an unknown force comes again along the way; "" of any other lack."""
    verdict = found.search.verdict
    if verdict.kind not in LACKING or WHERE not in verdict.coordinates or found.tracer is None:
        return ""
    if found.empirical is not None:  # a curve along the way, which is no wave
        return ""
    if (seen := repeating(found.tracer, found.split)) is None:
        return ""
    turns = found.recording is None or is_unit(found.recording.channels["position"].unit, "angle")
    often = f"every {2e3 * math.pi / seen.number:.4g} mm"
    often = f"{seen.number:.4g} times a turn" if turns else often
    return (
        f"A force that repeats {often} shows in the recorded accelerations: of what the drive and "
        f"friction leave of them on the runs that select it takes {100.0 * seen.part:.0f} % of the "
        "mean square away, as large as the fitted runs have it. So do the poles of a motor, teeth, "
        "and the balls of a bearing or a screw. No simulated run could be fitted with it."
    )
