"""At a cut nothing is missing: pieces hold together what the whole run holds."""

from itertools import pairwise

import numpy as np
import pytest
from axis_recordings import LET_ALONE, MAP, written

from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.problems import InvalidInput

TIME = 0.004 * np.arange(600)
ANGLE = 300.0 * TIME + 20.0 * np.sin(9.0 * TIME)
FILTER = 'filter = { kind = "butterworth", order = 2, cutoff = "8 Hz" }'
KEYS = {
    "unwrapped": ('wraps = "360 deg"', ""),
    "filtered": (f'wraps = "360 deg"\n{FILTER}', FILTER),
    "late": ('wraps = "360 deg"\nclock_shift = "-10 ms"', 'clock_shift = "20 ms"'),
    "held": ('wraps = "360 deg"', 'held = "after"\nclock_shift = "20 ms"'),
    "limited": ('wraps = "360 deg"', 'limits = ["-9 lbf*in", "4.9 lbf*in"]\nclock_shift = "20 ms"'),
}


def _recorded(folder, keys, pieces, role="input"):
    position, torque = keys
    described = MAP[: MAP.index("[split]")] + MAP[MAP.index("[channels.position]") :]
    described = described.replace("[runs]", f"[runs]\npieces = {pieces}")
    described = described.replace("may_rest = true", f"may_rest = true\n{position}")
    described = described.replace('role = "input"', f'role = "{role}"\n{torque}')
    rows = [
        f"0,{1e3 * t:.1f},{a % 360.0:.6f},{5.0 * np.sin(7.0 * t):.6f}"
        for t, a in zip(TIME, ANGLE, strict=True)
    ]
    return written(folder, ["take,ms,angle,torque", *rows], described)


@pytest.mark.parametrize("role", ["input", "measured"])
@pytest.mark.parametrize("key", sorted(KEYS))
def test_together_they_are_the_whole_run(tmp_path, key, role):
    (whole,) = _recorded(tmp_path, KEYS[key], 1, role).runs
    pieces = _recorded(tmp_path, KEYS[key], 4, role).runs
    ends = [whole.rows[0], 150, 300, 450, whole.rows[1]]
    assert [run.rows for run in pieces] == list(pairwise(ends))
    np.testing.assert_array_equal(np.concatenate([run.time for run in pieces]), whole.time)
    for name, values in whole.channels.items():
        seen = np.concatenate([run.channels[name] for run in pieces])
        np.testing.assert_array_equal(seen, values)
        compared = np.concatenate([run.compared(name) for run in pieces])
        np.testing.assert_array_equal(compared, whole.compared(name))


@pytest.mark.parametrize("key", ["filtered", "late"])
def test_each_is_replayed_behind_the_one_before_it(tmp_path, key):
    replays = axis_replays(_recorded(tmp_path, KEYS[key], 4), AxisSignals())
    assert [replay.before is None for replay in replays] == [True, False, False, False]


def test_what_goes_on_beyond_a_turn_is_told_of_the_run(tmp_path):
    with pytest.raises(InvalidInput, match=r"wraps.*goes on beyond that.*in take 0\""):
        _recorded(tmp_path, ('wraps = "180 deg"', ""), 4)


def test_a_sensor_that_a_piece_lacks_is_not_asked_for_in_the_others(tmp_path):
    speed = f"""
[channels.speed]
column = "rate"
unit = "deg/s"
sign = -1
role = "measured"
optional = true
{FILTER}
"""
    described = LET_ALONE + MAP[MAP.index("[channels.position]") : MAP.index("[channels.torque]")]
    described = described.replace("[runs]", "[runs]\npieces = 3") + speed
    rows = [
        f"0,{t:.3f},{a:.6f},{'' if t < 0.8 else f'{180.0 * np.cos(9.0 * t):.6f}'}"
        for t, a in zip(TIME, 20.0 * np.sin(9.0 * TIME), strict=True)
    ]
    runs = written(tmp_path, ["take,s,angle,rate", *rows], described).runs
    assert ["speed" in run.channels for run in runs] == [False, True, True]
    seen = np.concatenate([run.channels["speed"] for run in runs[1:]])
    assert np.isfinite(seen).all()
