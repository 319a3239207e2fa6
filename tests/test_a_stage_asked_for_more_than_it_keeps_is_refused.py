"""Memories of controllers are of a fixed size; what does not fit is said, not cut off."""

from dataclasses import dataclass

import pytest

from simpter_hybrid.checks.validation import validate
from simpter_hybrid.controllers.hand import HandAtTip
from simpter_hybrid.controllers.measurement import Measurement
from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.problems import InvalidInput

LINE = load("line-y24")


@pytest.mark.parametrize(("late", "refused"), [(63.0, False), (63.1, True)])
def test_a_delay_of_more_samples_than_are_kept(late, refused):
    hand = HandAtTip(0.1, 1.0, 0.1, delay=late * LINE.period)
    asked = LINE.replace(controllers=(*LINE.controllers, (hand, 1)))
    if not refused:
        return validate(asked)
    with pytest.raises(InvalidInput, match=r"stages\.\d\.delay: beyond the past that is kept"):
        validate(asked)


def test_more_coordinates_than_are_measured():
    @dataclass(frozen=True)
    class Few(Measurement):
        most_coordinates = 1

    with pytest.raises(InvalidInput, match=r"too many coordinates, got 2; expected .* at most 1"):
        validate(LINE.replace(controllers=((Few(), 1), *LINE.controllers)))
