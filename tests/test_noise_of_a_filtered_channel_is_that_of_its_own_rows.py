"""Two channels that share a column by `where` do not share their noise, filtered or moved."""

import numpy as np
import pytest
from axis_recordings import MAP, written

from simpter_hybrid.identification.recordings.noise import channel_noise

ROWS, NOISE = 2000, 0.1
FILTER = 'filter = { kind = "butterworth", cutoff = "20 Hz", order = 2 }\n'


def _noise(folder, own, neighbour, share):
    """Noise of the angle [deg]; `share`: so many of each 400 rows are the angle's."""
    index = np.arange(ROWS)
    on = index % 400 < share
    white = np.random.default_rng(3).normal(0.0, 1.0, ROWS)
    angle = 30.0 * np.sin(0.05 * index) + NOISE * white
    column = np.where(on, angle, 100.0 * np.cos(0.07 * index) + neighbour * white)
    part = 'where = { column = "on", equals = 1 }\n' if share < 400 else ""
    described = MAP.replace('role = "measured"\n', f'role = "measured"\n{part}{own}', 1)
    rows = [f"0,{4 * k},{column[k]:.6f},{k % 5},{int(on[k])}" for k in range(ROWS)]
    recording = written(folder, ["take,ms,angle,torque,on", *rows], described)
    return float(np.degrees(channel_noise(recording, "position")))


@pytest.mark.parametrize("own", [FILTER, 'clock_shift = "2 ms"\n'])
def test_a_neighbours_noise_is_none_of_it(tmp_path, own):
    quiet, loud = (_noise(tmp_path, own, size, 200) for size in (0.01, 20.0))
    assert loud == quiet
    assert quiet == pytest.approx(_noise(tmp_path, own, 0.0, 400), rel=0.1)


def test_in_stretches_too_short_for_the_filter_it_stays_as_it_is(tmp_path):
    assert _noise(tmp_path, FILTER, 20.0, 12) == pytest.approx(NOISE, rel=0.25)
