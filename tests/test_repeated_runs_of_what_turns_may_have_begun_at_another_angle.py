"""A counter that begins at nought in each run hides what comes once a turn."""

from simpter_hybrid.identification.reporting.told_apart import repeated_sentence

ANGLE = "or the runs began at another angle of something that comes once a turn"
PAIR = (("run 1", "run 2"),)


def test_the_angle_is_named_beside_another_device_or_load():
    said = repeated_sentence(PAIR, 8.9, turns=True)
    assert f"(another device, a load), {ANGLE}, log it as a `constant` of each run" in said


def test_of_what_goes_straight_no_angle_is_said():
    assert ANGLE not in repeated_sentence(PAIR, 8.9)
