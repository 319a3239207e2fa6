"""The verdict on one round, shown as little as a test needs."""

from collections.abc import Sequence
from typing import Any

from simpter_hybrid.identification.tracing.limits import REPEATED
from simpter_hybrid.identification.tracing.rivals import LEAST_GAIN
from simpter_hybrid.identification.tracing.verdict import Evidence, Verdict, judge


def judged(
    trials: Sequence, before: Sequence, after: Sequence, floor: float, **given: Any
) -> Verdict:
    """Of a first round at the floor of repeated runs that go both ways, unless `given` says."""
    usual = {
        "ratio": 1.0, "limit": REPEATED, "least": LEAST_GAIN, "one_way": False, "found": (),
        "mistakable": {},
    }  # fmt: skip
    return judge(Evidence(trials, before, after, floor, **{**usual, **given}))
