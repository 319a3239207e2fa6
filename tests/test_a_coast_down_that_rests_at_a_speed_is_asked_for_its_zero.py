"""What is let alone stops at zero: a level at which its speed stays is the sensor's."""

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.rest_level import resting

TIME, NOISE = np.linspace(0.0, 4.0, 800), 0.05
DRAW = NOISE * np.random.default_rng(2).standard_normal(TIME.size)
STOPS = np.maximum(20.0 - 7.0 * TIME, 0.0) + DRAW


@pytest.mark.parametrize("way", [1.0, -1.0])
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_level_at_which_it_stays_is_found(way, sign):
    rows, level = resting(TIME, way * STOPS + sign, NOISE)
    assert rows == pytest.approx(800 * (1.0 - 20.0 / 28.0), abs=10)
    assert level == pytest.approx(sign, abs=0.02)


@pytest.mark.parametrize("course", [
    STOPS, 20.0 * np.exp(-TIME) + DRAW, 20.0 / (1.0 + 4.0 * TIME) + DRAW, 20.0 - 3.0 * TIME + DRAW,
    20.0 * np.exp(-TIME) * np.cos(9.0 * TIME) + DRAW,
], ids=["a stop", "drag", "drag by the square", "no stop yet", "a swing"])  # fmt: skip
def test_what_stops_at_zero_or_slows_still_has_none(course):
    assert resting(TIME, course, NOISE)[0] == 0
