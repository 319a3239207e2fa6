"""Beside the rows in which a channel applies its column may hold nothing, which is no value."""

import numpy as np
import pytest
from axis_recordings import MAP, written

PART = 'where = { column = "on", equals = 1 }\n'
ANGLE = 30.0 * np.sin(0.05 * np.arange(400))


def _read(folder, own):
    described = MAP.replace('role = "measured"\n', f'role = "measured"\n{own}', 1)
    on = np.arange(400) // 100 % 2
    cells = [f"{a:.6f}" if k else "" for a, k in zip(ANGLE, on, strict=True)]
    rows = [f"0,{4 * k},{a},{k % 5},{o}" for k, (a, o) in enumerate(zip(cells, on, strict=True))]
    run = written(folder, ["take,ms,angle,torque,on", *rows], described).runs[0]
    return run.channels["position"], on == 1


@pytest.mark.parametrize(
    "own",
    [
        PART,
        PART + 'filter = { kind = "butterworth", cutoff = "20 Hz", order = 2 }\n',
        PART + 'clock_shift = "8 ms"\n',
    ],
)
def test_it_has_values_there_and_nowhere_else(tmp_path, own):
    seen, on = _read(tmp_path, own)
    on = on[on.size - seen.size :]  # the first rows are before a shifted clock began
    assert np.array_equal(np.isfinite(seen), on)
    # Neither a filter far above the motion's 2 Hz nor 8 ms move it by more than this [rad].
    assert np.abs(seen + np.radians(ANGLE[-seen.size :]))[on].max() < np.radians(3.5)
