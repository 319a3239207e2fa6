"""Forces as fitted curves: knots, a line that a law knows too, drag that never drives."""

import numpy as np
import pytest
from effect_rig import rig

from simpter_hybrid.effects.empirical_force import EmpiricalDrag, EmpiricalForce
from simpter_hybrid.effects.viscous_drag import ViscousDrag
from simpter_hybrid.engine import simulate

KNOTS = (0.1, -0.2, 0.3, 0.05, -0.4, 0.2, 0.1)


def test_it_passes_through_its_knots_and_is_constant_beyond():
    for k, value in enumerate(KNOTS):
        assert EmpiricalForce.force(1.0 + 0.5 * k, 1.0, 4.0, *KNOTS) == pytest.approx(value)
    assert EmpiricalForce.force(7.0, 1.0, 4.0, *KNOTS) == KNOTS[-1]
    with pytest.raises(ValueError, match="high above low"):
        EmpiricalForce(low=1.0, high=1.0)


def test_a_constant_curve_of_drag_is_viscous_drag():
    curve = EmpiricalDrag(coordinate=0, high=10.0, **{f"c{k}": 0.2 for k in range(1, 8)})
    told, known = (simulate(rig([e])) for e in (curve, ViscousDrag(coordinate=0, coefficient=0.2)))
    # Solver tolerance 1e-10, some ten events.
    np.testing.assert_allclose(told.end[:3], known.end[:3], atol=1e-8)


def test_drag_never_drives():
    assert EmpiricalDrag.force(3.0, 10.0, *(-1.0,) * 7) == 0.0
