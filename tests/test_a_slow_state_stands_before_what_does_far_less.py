"""What a slow state of each run takes away, a coordinate that goes along with it does in part."""

import numpy as np
import pytest

from simpter_hybrid.identification.tracing.locating import or_slow
from simpter_hybrid.identification.tracing.signature import Dependence

DRIVE, SPEED, RUN, ANGLE = "friction:drive", "friction:speed", "friction:run", "load:position"


def _dependence(coordinate, gain):
    return Dependence(coordinate, gain, 0.005, 5000, *3 * [np.zeros(1)])


@pytest.mark.parametrize(
    ("drive", "told"), [(0.05, (RUN,)), (0.15, (RUN, DRIVE, SPEED)), (0.3, (DRIVE, SPEED))]
)
def test_it_replaces_joins_or_is_not_told(drive, told):
    seen = [_dependence(DRIVE, drive), _dependence(SPEED, 0.01), _dependence(RUN, 0.4)]
    assert or_slow((DRIVE, SPEED), seen) == told


def test_coordinates_of_another_balance_stay():
    seen = [_dependence(ANGLE, 0.05), _dependence(DRIVE, 0.05), _dependence(RUN, 0.4)]
    assert or_slow((ANGLE, DRIVE), seen) == (RUN, ANGLE)


def test_without_a_coordinate_of_its_balance_nothing_is_added():
    assert or_slow((ANGLE,), [_dependence(ANGLE, 0.05), _dependence(RUN, 0.4)]) == (ANGLE,)
