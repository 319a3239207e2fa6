"""Friction by position of several clutches: plates are mounted as they come."""

import pytest

from simpter_hybrid.effects.position_friction import PositionFriction
from simpter_hybrid.identification.tip.candidates import tip_candidates

FOUND = {c.name: c for c in tip_candidates(2, 2, (30.0, 10.0), 4.0, 0.8)}


@pytest.mark.parametrize("number", ["", "-2"])
def test_amplitude_and_phase_of_each_are_its_own(number):
    name = f"position-friction{number} by clutch"
    values = {p.name: p.value for p in FOUND[name].parameters}
    values |= {f"{name}.1.once_cos": 0.2, f"{name}.2.once_sin": -0.1}
    assert FOUND[name].made(values) == (
        PositionFriction(clutch=0, once_cos=0.2),
        PositionFriction(clutch=1, once_sin=-0.1),
    )


def test_a_second_wave_is_tried_where_one_promises_something():
    assert FOUND["position-friction-2"].simpler == "position-friction"
    each = FOUND["position-friction-2 by clutch"]
    assert each.simpler == "position-friction by clutch"
    assert each.family == FOUND["position-friction"].family
