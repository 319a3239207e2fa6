"""A supply gives no more than its voltage: a motor told more turns no faster, however long."""

from math import exp

import numpy as np
import pytest
from axis_recordings import written
from motor_by_voltage import FRICTION, MAP, MODEL, J, K, R

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.axis.drive import drive_candidates
from simpter_hybrid.identification.diagnosis import diagnose

#: What is told [V], and the most that the supply gives.
TOLD, MOST = (4.0, 6.0, 8.0, 9.0, 10.0, 11.0, 12.0), 8.5
DRIVE = """[channels.drive]
column = "volt"
unit = "V"
sign = 1
role = "input"
held = "after"
"""


def stairs(folder):
    """Three takes of voltages in steps, each a closed form: an exponential to its own speed."""
    generator, step, rows = np.random.default_rng(3), 0.01, ["take,s,rate,volt"]
    brake = K * K / R
    for take in range(3):
        speed = 40.0
        for k, told in enumerate(np.repeat(generator.permutation(TOLD), 30)):
            seen = speed + generator.normal(0.0, 0.2)
            rows.append(f"{take},{k * step:.2f},{seen:.3f},{told}")
            top = (K * min(told, MOST) / R - FRICTION) / brake
            speed = top + (speed - top) * exp(-brake / J * step)
    return written(folder, rows, MAP[: MAP.index("[channels.duty]")] + DRIVE)


def test_a_motor_by_voltage_is_asked_for_a_limit_of_either_and_others_for_one():
    tried = {c.name: c for c in drive_candidates(parse(MODEL), sensed=False)}
    backs = {name: c.effect.back for name, c in tried.items() if name.endswith("-limit")}
    assert backs == {"drive-limit": pytest.approx(K * K / R), "supply-limit": 0.0}
    assert tried["drive-limit"].family == tried["supply-limit"].family


@pytest.mark.slow
def test_it_is_named_with_its_voltage_and_the_corrected_model_lacks_nothing(tmp_path):
    recording = stairs(tmp_path)
    done = diagnose(recording, parse(MODEL)).search
    assert [e.name for e in done.corrected.effects] == ["supply-limit"]
    # The noise of 0.2 rad/s on some 250 rows above it leaves a part in a thousand.
    assert done.corrected.values["supply-limit.limit"] == pytest.approx(MOST, rel=5e-3)
    corrected = done.corrected.predictor.scenario(done.corrected.values)
    assert diagnose(recording, corrected).search.verdict.kind == "nothing missing"
