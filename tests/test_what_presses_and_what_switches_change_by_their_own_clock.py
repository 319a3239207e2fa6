"""Not the drive alone: a pressure and a switch by another clock change between two rows as well."""

import numpy as np
import pytest
from axis_recordings import written

from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.axis.signals import AxisSignals

MAP = """
[time]
column = "s"
unit = "s"
"""
for _signal, _unit, _role, _more in (
    ("position", "rad", "measured", ""), ("drive", "V", "input", 'held = "after"'),
    ("pressure", "V", "input", 'held = "after"\nclock_shift = "2.5 ms"'),
    ("torque_on", "1", "input", 'held = "before"\nclock_shift = "-2 ms"'),
):  # fmt: skip
    MAP += f"""[channels.{_signal}]
column = "{_signal}"
unit = "{_unit}"
sign = 1
role = "{_role}"
{_more}
"""


def test_what_presses_and_what_switches_change_by_their_own_clock(tmp_path):
    rows = ["s,position,drive,pressure,torque_on"]
    for k in range(400):
        on = int(k < 200)
        rows.append(f"{0.01 * k:.2f},{np.sin(0.01 * k):.6f},{np.cos(0.03 * k):.4f},{on},{on}")
    recording = written(tmp_path, rows, MAP)
    (replay,) = axis_replays(recording, AxisSignals())
    rig = AxisRig()
    period = rig.period(replay, 1e-5)  # a twentieth of a row meets both
    press, released = rig.pack(replay, period)[3:].reshape(-1, 3)[:, :2].T
    off = replay.stamp + period * np.array([np.argmax(press < 0.5), np.argmax(released > 0.5)])
    # Rows hold from 2.00 s on, and up to 1.99 s.
    assert off == pytest.approx([2.0 + 0.0025, 1.99 - 0.002], abs=1e-9)
