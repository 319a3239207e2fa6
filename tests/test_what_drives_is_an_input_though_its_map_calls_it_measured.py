"""A command at its limit is no sensor that is cut off."""

import numpy as np
import pytest
from axis_recordings import MAP, written

from simpter_hybrid.identification.reporting.cautions import cut_off_sentence

TIME = np.arange(0.0, 2.0, 0.005)
ANGLE = 20.0 * np.sin(3.0 * TIME)
DRIVE = np.clip(30.0 * np.cos(3.0 * TIME), -10.0, 10.0)
VOLTS = '[channels.torque]\ncolumn = "torque"\nunit = "lbf*in"'
MEASURED = MAP.replace(
    VOLTS, VOLTS.replace("channels.torque", "channels.drive").replace("lbf*in", "V")
)
MEASURED = MEASURED.replace('role = "input"', 'role = "measured"\nheld = "after"')


def _read(folder, described):
    rows = ["take,ms,angle,torque"]
    rows += [f"{n},{1e3 * t:.0f},{a:.4f},{u:.3f}" for n in range(3)
             for t, a, u in zip(TIME, ANGLE, DRIVE, strict=True)]  # fmt: skip
    return written(folder, rows, described)


def test_it_is_taken_for_one_with_a_remark(tmp_path):
    recording = _read(tmp_path, MEASURED)
    assert recording.channels["drive"].role == "input"
    (said,) = (f for f in recording.findings if "measured" in f.what)
    assert said.right == 'role = "input"'
    assert cut_off_sentence(recording.findings) == ""


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("channels.drive", "channels.torque"),  # a sensor's
        ("[time]", "driven = false\n[time]"),
        ('"measured"\nheld', '"measured"\noptional = true\nheld'),
        ('role = "measured"\nmay_rest', 'role = "input"\nmay_rest'),  # a tester moves the axis
    ],
)
def test_what_may_be_compared_is_left(tmp_path, old, new):
    unit = ('unit = "V"', 'unit = "lbf*in"') if "torque" in new else ("", "")
    recording = _read(tmp_path, MEASURED.replace(old, new).replace(*unit))
    name = "torque" if "torque" in new else "drive"
    assert recording.channels[name].role == "measured"
