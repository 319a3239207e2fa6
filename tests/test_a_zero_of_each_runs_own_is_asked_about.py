"""A load cell set up anew before each run: no effect does that, and a reader is asked about it."""

from types import SimpleNamespace

import numpy as np
import pytest
from axis_recordings import written
from moved_axis import MAP, model

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.map_changes import OWN_ZERO
from simpter_hybrid.identification.own_zeros import own_zeros
from simpter_hybrid.identification.reporting.doubted_sentence import doubted_sentence

DECLARED = parse(model(0.4, 'coulomb = "5 N", viscous = "20 N*s/m"'))
SPLIT = """
[split]
fit = ["run 0", "run 1", "run 2"]
select = ["run 3", "run 4"]
report = ["run 5"]
"""
#: Of each run [N].
ZEROS = (0.0, 1.1, -0.7, 0.6, -1.3, 0.4)
TIME = 0.01 * np.arange(900)


def recorded(folder, zeros, rise=0.0):
    """Strokes both ways at six speeds; `rise`: Stribeck's, which the model lacks."""
    generator, rows = np.random.default_rng(3), ["run,t,x,F"]
    for k, zero in enumerate(zeros):
        rate = 1.0 + 0.4 * k
        x, v = 0.05 * np.sin(rate * TIME), 0.05 * rate * np.cos(rate * TIME)
        friction = 5.0 * (1.0 + rise * np.exp(-((v / 0.02) ** 2)))
        force = friction * np.sign(v) + 20.0 * v - 0.4 * rate**2 * x + zero
        force += generator.normal(0.0, 0.1, force.size)
        rows += [f"{k},{t:.2f},{a:.7f},{f:.4f}" for t, a, f in zip(TIME, x, force, strict=True)]
    return written(folder, rows, MAP + SPLIT)


def doubts(folder, *args):
    done = diagnose(recorded(folder, *args), DECLARED)
    return {d.change.kind: d for d in done.doubts}


@pytest.mark.slow
def test_it_is_told_with_how_far_they_are_apart(tmp_path):
    found = doubts(tmp_path, ZEROS)
    assert list(found) == [OWN_ZERO]
    zeros = dict(found[OWN_ZERO].change.zeros)
    # The held-out run is not looked at; 900 rows tell a mean to 0.1 N / 30.
    assert set(zeros) == {f"run {k}" for k in range(5)}
    apart = [zeros[f"run {k}"] - ZEROS[k] for k in range(5)]
    assert np.ptp(apart) < 0.05
    said = doubted_sentence(tuple(found.values()))
    assert said.startswith("Has a sensor another zero in each run")
    assert "with nothing acting" in said


@pytest.mark.slow
def test_one_zero_of_all_runs_is_an_effect_and_no_question(tmp_path):
    assert doubts(tmp_path, (1.1,) * 6) == {}


@pytest.mark.slow
def test_what_is_missing_in_each_is_none(tmp_path):
    assert doubts(tmp_path, (0.0,) * 6, 0.5) == {}


def test_what_was_told_or_drives_nothing_has_no_sensor(tmp_path):
    torque = SimpleNamespace(channels={"torque": SimpleNamespace(role="input")})
    for rig in (AxisRig(sensed=False), AxisRig(alone=True, sensed=False)):
        bench = SimpleNamespace(predictor=SimpleNamespace(rig=rig, declared=DECLARED))
        assert own_zeros(bench, torque, {}) is None
