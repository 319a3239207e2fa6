"""Whatever a fit may find of an effect can be written into a model that other commands read."""

import dataclasses

import pytest

from simpter_hybrid.identification.axis.candidates import axis_candidates
from simpter_hybrid.identification.axis.sizes import AxisSizes
from simpter_hybrid.identification.rotor.candidates import rotor_candidates
from simpter_hybrid.identification.tip.candidates import tip_candidates

RIGS = {
    "turning axis": axis_candidates(AxisSizes(1.0, 1.0, 1.0, 4.0, 0.1, True, -3.0, 7.0)),
    "slide": axis_candidates(AxisSizes(1.0, 1.0, 1.0, 4.0, 0.1, False, -3.0, 7.0)),
    "rotor": rotor_candidates(),
    "robot": tip_candidates(2, 4, (30.0, 10.0), 4.0, 0.8, "tilt by joint", (0.3, 0.4)),
}


@pytest.mark.parametrize("rig", RIGS)
def test_bounds_of_a_fit_lie_within_those_of_the_effect(rig):
    outside = []
    for candidate in RIGS[rig]:
        fitted = {p.name: p for p in candidate.parameters}
        for k, effect in enumerate(candidate.effects()):
            known = {f.name: f.metadata for f in dataclasses.fields(effect)}
            for name, field in candidate.fields(k):
                low, high, above = (known[field].get(end) for end in ("low", "high", "above"))
                p = fitted[name]
                if (
                    (low is not None and p.lower < low)
                    or (high is not None and p.upper > high)
                    or (above is not None and p.lower <= above)
                ):
                    outside.append(name)
    assert outside == []
