"""Each stretch between gaps of a run is filtered as if it were alone."""

import numpy as np
import pytest
from axis_recordings import MAP, written

from simpter_hybrid.identification.recordings.filtering import FEWEST, Filter
from simpter_hybrid.problems import InvalidInput

FILTER = 'filter = { kind = "butterworth", cutoff = "5 Hz", order = 2 }\n'
TIME = 0.005 * np.arange(400)
#: It goes up by 10 deg/s, and down again behind a gap of 4 s.
STRETCHES = [(TIME, 10.0 * TIME), (6.0 + TIME, 100.0 - 10.0 * TIME)]


def _position(folder, stretches):
    rows = [f"0,{1e3 * t:.1f},{a:.6f},{k % 5}" for part in stretches
            for k, (t, a) in enumerate(zip(*part, strict=True))]  # fmt: skip
    described = MAP.replace("may_rest = true\n", f"may_rest = true\n{FILTER}")
    recorded = written(folder, ["take,ms,angle,torque", *rows], described)
    return recorded.runs[0].channels["position"]


def test_a_straight_course_stays_straight_up_to_it(tmp_path):
    seen = -np.degrees(_position(tmp_path, STRETCHES))
    told = np.concatenate([course for _, course in STRETCHES])
    # What a filter does at its ends [deg]; run across the gap it is 38 deg off there.
    assert np.abs(seen - told).max() < 0.1


def test_both_sides_are_those_of_two_runs(tmp_path):
    each = [_position(tmp_path, [part]) for part in STRETCHES]
    seen = _position(tmp_path, STRETCHES)
    np.testing.assert_allclose(seen, np.concatenate(each), rtol=0.0, atol=1e-12)


@pytest.mark.parametrize("order", [1, 2, 8])
def test_a_stretch_of_too_few_rows_stays_as_it_is(order):
    fewest = FEWEST * order
    time = 0.005 * np.arange(fewest + 200.0) + 4.0 * (np.arange(fewest + 200) >= fewest)
    values = np.sin(0.3 * np.arange(time.size))
    seen = Filter(order, 5.0).apply(time, values)
    np.testing.assert_array_equal(seen[:fewest], values[:fewest])
    assert not np.array_equal(seen[fewest:], values[fewest:])


def test_noise_of_rows_that_stay_as_they_are_counts_whole():
    filtered, fewest = Filter(2, 5.0), FEWEST * 2
    time = 0.005 * np.arange(4000.0)
    time[3000:] += 4.0 * (np.arange(1000) // fewest + 1)  # a quarter in stretches too short
    noise = np.random.default_rng(5).standard_normal(time.size)
    assert filtered.reach(time) == 0.75
    # Of a thousand rows of white noise, known to 3 %.
    assert np.std(filtered.apply(time, noise)) == pytest.approx(filtered.left(time), rel=0.07)


def test_one_that_reaches_hardly_a_row_is_refused(tmp_path):
    bits = [(4.0 * k + TIME[:10], 10.0 * TIME[:10]) for k in range(20)]
    with pytest.raises(InvalidInput, match="filters hardly anything"):
        _position(tmp_path, bits)
