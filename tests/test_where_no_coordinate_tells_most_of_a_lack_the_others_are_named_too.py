"""A lack of which no coordinate takes half away depends on those named and on others."""

import numpy as np
import pytest

from simpter_hybrid.identification.reporting.dependence_text import among_others
from simpter_hybrid.identification.tracing.signature import Dependence

NAMED = ("force:displacement_since_reversal", "force:slip_velocity")


def seen(most, p_value=0.005):
    gains = {NAMED[0]: most, NAMED[1]: 0.2, "force:speed": 0.2, "force:acceleration": 0.14}
    bins = np.zeros(3)
    return [
        Dependence(name, gain, p_value if "acc" in name else 0.005, 5000, bins, bins, bins)
        for name, gain in gains.items()
    ]


@pytest.mark.parametrize(
    ("most", "said"), [(0.29, ", among others (less on acceleration)"), (0.51, "")]
)
def test_others_are_told_unless_one_takes_half_away(most, said):
    assert among_others(NAMED, seen(most)) == said


def test_what_is_not_sure_is_not_told():
    assert among_others(NAMED, seen(0.29, p_value=0.05)) == ""


def test_nor_beside_what_no_curve_was_asked_of():
    assert among_others(("force:slow",), seen(0.29)) == ""
