"""What a sensor's zero and a part that stands turned do alike is laid to neither alone."""

import pytest
import robot_replays as robot

from simpter_hybrid.identification.reporting.meaning import meaning


@pytest.mark.parametrize(("name", "both"), [("angle-offset", True), ("force-gain", False)])
def test_of_a_zero_of_an_angle(name, both):
    words = meaning(robot.candidates()[name])
    assert ("a part that stands turned" in words) == both
    assert ("not of the machine" in words) != both
