"""A switch that is logged after each row holds from there, however what it switches goes on."""

import numpy as np
import pytest
from axis_recordings import written

from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.axis.signals import AxisSignals

PERIOD = 1e-3
MAP = """
[time]
column = "s"
unit = "s"
[channels.position]
column = "q"
unit = "rad"
sign = 1
role = "measured"
[channels.duty]
column = "u"
unit = "1"
sign = 1
role = "input"
{drive}
[channels.torque_on]
column = "on"
unit = "1"
sign = 1
role = "input"
{switch}
"""
TIME = 0.01 * np.arange(400)
#: The motor is on up to this row, and released from the next on.
LAST = 199


@pytest.mark.parametrize("drive", ["", 'held = "after"', 'held = "before"'])
@pytest.mark.parametrize(("switch", "off"), [('held = "after"', 2.0), ('held = "before"', 1.99)])
def test_a_motor_is_released_where_its_own_channel_says(tmp_path, drive, switch, off):
    rows = [
        f"{t:.2f},{np.sin(t):.6f},{np.cos(3 * t):.4f},{int(k <= LAST)}" for k, t in enumerate(TIME)
    ]
    recording = written(tmp_path, ["s,q,u,on", *rows], MAP.format(drive=drive, switch=switch))
    (replay,) = axis_replays(recording, AxisSignals())
    released = AxisRig().pack(replay, PERIOD)[3:].reshape(-1, 3)[:, 1]
    assert PERIOD * np.flatnonzero(released)[0] == pytest.approx(off, abs=1e-9)
