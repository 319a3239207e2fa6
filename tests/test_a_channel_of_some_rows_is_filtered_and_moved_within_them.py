"""Beside the rows in which a channel applies its column may hold nothing, which is no value."""

import numpy as np
import pytest
from axis_recordings import MAP, written

from simpter_hybrid.identification.recordings.filtering import FEWEST, Filter

PART = 'where = { column = "on", equals = 1 }\n'
FILTER = 'filter = { kind = "butterworth", cutoff = "20 Hz", order = 2 }\n'
ANGLE = 30.0 * np.sin(0.05 * np.arange(400))


def _read(folder, own):
    described = MAP.replace('role = "measured"\n', f'role = "measured"\n{own}', 1)
    on = np.arange(400) // 100 % 2
    cells = [f"{a:.6f}" if k else "" for a, k in zip(ANGLE, on, strict=True)]
    rows = [f"0,{4 * k},{a},{k % 5},{o}" for k, (a, o) in enumerate(zip(cells, on, strict=True))]
    run = written(folder, ["take,ms,angle,torque,on", *rows], described).runs[0]
    return run.channels["position"], on == 1


@pytest.mark.parametrize("own", ["", FILTER])
def test_it_has_values_there_and_nowhere_else(tmp_path, own):
    seen, on = _read(tmp_path, PART + own)
    assert np.array_equal(np.isfinite(seen), on)
    # A filter far above the motion's 2 Hz moves it by less than this [rad], at a stretch's ends.
    assert np.abs(seen + np.radians(ANGLE))[on].max() < np.radians(1.0)


@pytest.mark.parametrize("order", range(1, 9))
def test_a_stretch_is_filtered_from_one_row_above_the_fewest_on(order):
    made, fewest = Filter(order, 20.0), FEWEST * order
    for size in (fewest, fewest + 1):
        values = np.sin(np.arange(float(size)))
        changed = not np.array_equal(made.apply(0.004 * np.arange(size), values), values)
        assert changed == (size > fewest)


def test_moved_it_has_none_where_another_clock_had_none(tmp_path):
    seen, on = _read(tmp_path, PART + 'clock_shift = "40 ms"\n')
    first = on.size - seen.size  # rows before the clock began are left out
    began = on & ~np.concatenate([np.zeros(10, bool), on[:-10]])  # ten rows of 4 ms
    assert np.array_equal(np.isfinite(seen), (on & ~began)[first:])
    before = np.concatenate([np.zeros(10), ANGLE[:-10]])[first:]
    assert np.abs(seen + np.radians(before))[np.isfinite(seen)].max() < 1e-6
