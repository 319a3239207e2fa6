"""``may_rest`` allows a position to stay, and what rests goes on slowly."""

import numpy as np
import pytest
from axis_recordings import LET_ALONE, written

MAP = f"""{LET_ALONE}[channels.position]
column = "x"
unit = "mm"
sign = 1
role = "measured"
may_rest = true
"""
TIME, REST = np.arange(0.0, 10.0, 0.002), slice(2000, 2600)


def _course(rests):
    """A slide that goes to and fro, or rests for 1.2 s at a turn, where it goes on from."""
    x = 40.0 * np.cos(2.0 * np.pi * 0.25 * TIME)
    if rests:
        later = x[REST.start : REST.start + TIME.size - REST.stop].copy()
        x[REST], x[REST.stop :] = x[REST.start], later
    return x


def _found(folder, x):
    rows = ["take,s,x"]
    rows += [f"{n},{t:.4f},{v:.4f}" for n in range(3) for t, v in zip(TIME, x, strict=True)]
    findings = written(folder, rows, MAP).findings
    return [(f.run, f.time) for f in findings if "repeats one value" in f.what]


@pytest.mark.parametrize("noise", [0.0, 0.02])
def test_rows_that_hang_in_mid_motion_are_told(tmp_path, noise):
    x = _course(rests=False) + np.random.default_rng(1).normal(0.0, noise, TIME.size)
    x[1200:3220] = x[1200]  # a whole period and 1.5 mm: a larger jump is refused
    assert _found(tmp_path, x) == [(f"take {n}", pytest.approx(2.4)) for n in range(3)]


def test_what_sticks_and_snaps_is_none(tmp_path):
    """Half a millimetre within a row, and rest again."""
    snaps = 0.5 * (np.arange(TIME.size) // 700)
    moving = np.where(np.arange(TIME.size) < 700, _course(rests=False), 0.0)
    assert _found(tmp_path, moving + snaps + np.where(moving == 0.0, moving[699], 0.0)) == []


@pytest.mark.parametrize("step", [0.0, 0.05])
def test_a_rest_is_none(tmp_path, step):
    x = _course(rests=True)
    assert _found(tmp_path, step * np.round(x / step) if step else x) == []
