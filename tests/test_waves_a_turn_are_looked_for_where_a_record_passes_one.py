"""Bolts, teeth and poles repeat several times a turn: friction and force, where it can be seen."""

import math

import pytest

from simpter_hybrid.identification.axis.candidates import axis_candidates
from simpter_hybrid.identification.axis.sizes import AxisSizes

TURN = 2 * math.pi


@pytest.mark.parametrize(
    ("reach", "turning", "waves"),
    [
        (2.0 * TURN, True, range(2, 9)),
        (0.3 * TURN, True, range(4, 9)),  # 0.9 of the third: as good as a slope
        (0.1 * TURN, True, ()),
        (2.0 * TURN, False, ()),  # a length has no turns
    ],
)
def test_a_whole_wave_must_have_been_passed(reach, turning, waves):
    library = axis_candidates(
        AxisSizes(1.0, 2.0, 0.5, 4.0, 0.1, turning, low=-0.5 * reach, high=0.5 * reach)
    )
    known = {c.name: c for c in library}
    for kind, family in (("position-friction", "position"), ("ripple-force", "load by position")):
        found = {n for n in range(2, 20) if f"{kind}-{n}" in known}
        assert found == set(waves)
        assert {known[f"{kind}-{n}"].family for n in found} <= {family}
        assert all(known[f"{kind}-{n}"].effect.number == n for n in found)
