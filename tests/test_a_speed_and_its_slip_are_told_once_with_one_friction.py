"""On one axis with one friction slip velocity is speed: a sentence names the stronger alone."""

import pytest

from simpter_hybrid.identification.reporting.dependence_text import depends_on


@pytest.mark.parametrize(
    ("found", "said"),
    [
        (("force:speed", "force:slip_velocity", "force:time"), "speed and time"),
        (("force:slip_velocity", "force:speed"), "slip velocity"),
        (("joint_1:speed", "joint_1:slip_velocity"), "speed and slip velocity (joint_1)"),
    ],
)
def test_the_stronger_one_is_told(found, said):
    assert depends_on(found) == said
