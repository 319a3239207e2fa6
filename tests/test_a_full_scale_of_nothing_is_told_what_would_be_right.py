"""A clutch made in Python that takes no voltage is asked for one, with units."""

import pytest
from devices_for_tests import Block, Coulomb

from simpter_hybrid.checks.validation import validate
from simpter_hybrid.clutch import Clutch
from simpter_hybrid.problems import InvalidInput
from simpter_hybrid.scenario import Scenario


def test_a_full_scale_of_nothing_is_told_what_would_be_right():
    clutch = Clutch(Coulomb(1.0, 1.0), full_scale=0.0, threshold=-1.0)
    scenario = Scenario("weak", Block(1.0), (clutch,), (0.0,), (0.0,), 1.0)
    with pytest.raises(InvalidInput, match='got "0 V"; expected a voltage above 0 V, finite'):
        validate(scenario)
