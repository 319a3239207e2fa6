"""Modified quadratic and tabulated torque maps."""

import numpy as np
import pytest
from scipy.interpolate import PchipInterpolator

from simpter_hybrid.laws import ModifiedQuadratic
from simpter_hybrid.laws.table_torque import TableTorque

#: A fit whose vertex lies at 3 V: 2 (v - 3)^2 + 4; breakaway 2.5 (v - 2)^2 + 5.
BAR = ModifiedQuadratic(2.0, -12.0, 22.0, 2.5, -10.0, 15.0)
SPEEDLESS = ((0.0, 0.0, 0.0), (1.0, 0.2, 0.5), (2.0, 1.5, 2.0), (5.0, 9.0, 9.0), (10.0, 30.0, 40.0))


def of(law, name, **signals):
    """A law's function at given signals."""
    numbers = [*law.parameters().values(), *law.table()]
    given = law.parameters() | {"p": numbers, "table_at": len(law.parameters())} | signals
    function = law.functions()[name]
    wanted = function.__code__.co_varnames[: function.__code__.co_argcount]
    return function(**{key: given[key] for key in wanted})


def test_the_line_runs_from_the_origin_to_the_point_of_zero_slope():
    assert of(BAR, "slip_torque", excitation=0.0) == 0.0
    assert of(BAR, "slip_torque", excitation=1.5) == pytest.approx(2.0, rel=1e-15)  # half way to 4
    assert of(BAR, "slip_torque", excitation=3.0) == 4.0
    assert of(BAR, "break_torque", excitation=1.0) == pytest.approx(2.5, rel=1e-15)


def test_beyond_the_vertex_it_is_the_fitted_quadratic():
    for v in (3.0, 4.0, 10.0):
        assert of(BAR, "slip_torque", excitation=v) == pytest.approx(2.0 * (v - 3.0) ** 2 + 4.0)
        assert of(BAR, "break_torque", excitation=v) == pytest.approx(2.5 * (v - 2.0) ** 2 + 5.0)


def test_a_quadratic_that_rises_from_zero_has_no_line():
    law = ModifiedQuadratic(1.0, 0.5, 0.25, 1.0, 0.5, 0.25)
    assert of(law, "slip_torque", excitation=0.0) == 0.25
    assert of(law, "slip_torque", excitation=2.0) == 5.25


def test_a_table_is_scipys_monotone_interpolant():
    law = TableTorque(SPEEDLESS, ((0.0, 1.0), (1.0, 1.3), (2.0, 1.2)))
    v, slip, brk = np.array(SPEEDLESS).T
    factor = PchipInterpolator([0.0, 1.0, 2.0], [1.0, 1.3, 1.2])
    for x in np.linspace(0.0, 10.0, 57):
        expected = PchipInterpolator(v, slip)(x)
        # Same formula in another order of operations: a few ulp of 40 N m.
        found = of(law, "slip_torque", excitation=x, speed=0.7)
        assert found == pytest.approx(expected * factor(0.7), abs=1e-13)
        found = of(law, "break_torque", excitation=x)
        assert found == pytest.approx(PchipInterpolator(v, brk)(x), abs=1e-13)


def test_a_table_is_constant_beyond_its_speeds():
    law = TableTorque(SPEEDLESS, ((0.1, 1.0), (1.0, 1.5)))
    assert of(law, "slip_torque", excitation=10.0, speed=0.0) == 30.0
    assert of(law, "slip_torque", excitation=10.0, speed=9.0) == 45.0


@pytest.mark.parametrize("points", [(), ((0.0, 0.0, 0.0),), ((1.0, 0.0, 0.0), (1.0, 1.0, 1.0))])
def test_a_table_needs_two_rising_points(points):
    with pytest.raises(ValueError, match="points: "):
        TableTorque(points)
