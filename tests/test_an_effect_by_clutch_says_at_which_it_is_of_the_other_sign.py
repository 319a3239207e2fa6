"""Each place has a size of its own, and a sign of its own."""

import pytest

from simpter_hybrid.identification.reporting.other_ways import other_way

NAME = "degressive-speed by clutch"
FALLS = "friction falls with speed, ever less"


@pytest.mark.parametrize(
    ("rises", "said"),
    [
        ({"1": -0.4, "2": -0.1}, f" (here {FALLS})"),
        ({"2": -0.1}, f" (here {FALLS})"),
        ({"1": -0.4, "2": 0.03}, f" (at clutch 1 {FALLS})"),
        ({"1": 0.4, "2": 0.03}, ""),
    ],
)
def test_each_place_is_asked(rises, said):
    values = {f"{NAME}.{place}.rise": rise for place, rise in rises.items()}
    assert other_way(None, NAME, {**values, f"{NAME}.scale": 0.03, "stribeck.rise": -1.0}) == said
