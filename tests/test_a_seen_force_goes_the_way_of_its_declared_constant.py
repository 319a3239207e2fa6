"""A motor that is declared to push backwards does so by its sensor as well: no sign is wrong."""

import numpy as np
from axis_recordings import MODEL, written

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.axis.recorded import as_axis
from simpter_hybrid.identification.axis.seen_drive import seen_drive
from simpter_hybrid.identification.axis.signals import AxisSignals

BACKWARDS = MODEL.replace('constant = "1 N*m/V"', 'constant = "-1 N*m/V"')
MAP = """
[time]
column = "s"
unit = "s"
"""
for _signal, _unit, _role in (
    ("speed", "rad/s", "measured"), ("drive", "V", "input"), ("torque", "N*m", "measured")
):  # fmt: skip
    MAP += f"""[channels.{_signal}]
column = "{_signal}"
unit = "{_unit}"
sign = 1
role = "{_role}"
"""


def test_a_seen_force_goes_the_way_of_its_declared_constant(tmp_path):
    time = 0.004 * np.arange(2000)
    volts = 5.0 * np.sin(3.0 * time) + 2.0 * np.sin(7.3 * time)
    speed = 3.0 * np.cos(3.0 * time + 0.4)
    seen = -volts + 0.005 * np.random.default_rng(1).normal(size=time.size)
    rows = [",".join(f"{x:.6f}" for x in row) for row in zip(time, speed, volts, seen, strict=True)]
    recording = as_axis(written(tmp_path, ["s,speed,drive,torque", *rows], MAP))
    (remark,) = seen_drive(recording, parse(BACKWARDS), AxisSignals())
    assert remark.value == "it goes with a driver and a motor as declared"
