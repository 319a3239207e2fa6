"""A number of 1.7e9 s is rounded to 0.2 us: an input changes at a stamp, not beside it."""

import numpy as np
import pytest
from axis_recordings import MAP, written

K = np.arange(1, 301)


@pytest.mark.parametrize(("unit", "long_ago"), [("s", 1.7e9), ("ms", 1.7e12)])
def test_they_are_the_same(tmp_path, unit, long_ago):
    step = 0.002 if unit == "s" else 2.0
    rows = [f"0,{long_ago + step * k:.3f},{k % 7}.5,{k % 5}" for k in K]
    described = MAP.replace('unit = "ms"', f'unit = "{unit}"', 1)
    time = written(tmp_path, ["take,ms,angle,torque", *rows], described).runs[0].time
    # Within rounding of small numbers, not of large ones.
    assert time == pytest.approx(0.002 * K, abs=1e-12)
