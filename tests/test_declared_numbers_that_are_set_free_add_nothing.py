"""They are fitted to their ends beside any other candidate, since first fits of them stall."""

import pytest
import robot_replays as robot

from simpter_hybrid.identification.tip.candidates import tip_candidates


@pytest.mark.parametrize(
    ("name", "frees"),
    [
        ("time-constant by clutch", True),
        ("torque-scale", True),
        ("inertia", True),
        ("payload", False),  # a load
        ("second-lag by clutch", False),  # effects
        ("slew-limit-2", False),  # effects beside a declared number
        ("force-gain", False),  # a sensor's error
    ],
)
def test_declared_numbers_that_are_set_free_add_nothing(name: str, frees: bool) -> None:
    every = (*tip_candidates(2, 4, (0.1, 0.1), 20.0, 1.0), *robot.candidates().values())
    assert {c.name: c for c in every}[name].frees is frees
