"""A first run with the brake off shows nothing of it: the run that is pressed most is asked."""

import numpy as np
from axis_recordings import MODEL, written

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.axis.recorded import as_axis, unpressed
from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor

BRAKED = MODEL.replace('coulomb = "0.2 N*m"', 'coulomb = "0.2 N*m", normal = "0.1 N*m/V"')
MAP = """
[time]
column = "s"
unit = "s"
[runs]
boundaries = ["take"]
"""
for _signal, _unit, _role in (
    ("position", "rad", "measured"), ("torque", "N*m", "input"), ("pressure", "V", "input")
):  # fmt: skip
    MAP += f"""[channels.{_signal}]
column = "{_signal}"
unit = "{_unit}"
sign = 1
role = "{_role}"
"""


def test_a_model_is_asked_for_what_presses_where_it_presses(tmp_path):
    time = 0.01 * np.arange(300)
    rows = ["take,s,position,torque,pressure"]
    for take, press in enumerate((0.0, 2.0)):
        rows += [
            f"{take},{t:.2f},{0.1 * np.sin(3 * t):.6f},{np.cos(3 * t):.4f},{press}" for t in time
        ]
    recording = as_axis(written(tmp_path, rows, MAP))
    predictor = ScenarioPredictor(parse(BRAKED), AxisRig())
    assert unpressed(predictor, axis_replays(recording, AxisSignals()), recording) == ()
