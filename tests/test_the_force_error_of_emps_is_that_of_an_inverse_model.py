"""The authors' force error, of motions whose force is known in closed form."""

import importlib
import os
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from simpter_hybrid.effects.bias_force import BiasForce
from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.identification.maps import MAPS, find_model
from simpter_hybrid.identification.recordings.recording import RecordedRun, load_recording
from simpter_hybrid.identification.rigs.corrected import with_parameters

BENCHMARKS = Path(__file__).resolve().parent.parent / "benchmarks"
DATA = Path(os.environ.get("SIMPTER_DATA", "nowhere")) / "emps"
MASS, VISCOUS, COULOMB, OFFSET = 95.0, 200.0, 20.0, -3.0


@pytest.fixture
def measure(monkeypatch):
    monkeypatch.syspath_prepend(str(BENCHMARKS))
    return importlib.import_module("emps_force")


def strokes(gain: float) -> RecordedRun:
    """Two pieces long, at rest at both ends; the force is the declared model's with an offset."""
    step, rows = 1e-3, 12_501
    time = np.arange(rows) * step
    near = np.clip(np.minimum(time, time[-1] - time), 0.0, 1.0)
    position = 0.1 * np.sin(2.0 * time) * near**3 * (10.0 - 15.0 * near + 6.0 * near**2)
    speed = np.gradient(position, step)
    bent = np.gradient(speed, step)
    force = MASS * bent + VISCOUS * speed + COULOMB * np.sign(speed) + OFFSET
    channels = {"position": position, "drive": force / gain}
    return RecordedRun("run", "run", "run", (0, rows), time, channels)


def test_the_model_that_made_a_record_leaves_nothing_but_what_the_filter_does(measure):
    declared, run = load(find_model("emps")), strokes(measure.GAIN)
    right = replace(declared, effects=(BiasForce(bias=-OFFSET, coordinate=0),))
    assert measure.relative_error(right, run) < 1.5


def test_a_missing_offset_leaves_its_share_of_the_force(measure):
    declared, run = load(find_model("emps")), strokes(measure.GAIN)
    force = measure.GAIN * run.channels["drive"]
    share = 100.0 * abs(OFFSET) / np.sqrt(np.mean(force**2))
    assert measure.relative_error(declared, run) == pytest.approx(share, rel=0.03)


@pytest.mark.skipif(not DATA.is_dir(), reason="SIMPTER_DATA has no emps/")
def test_published_parameters_leave_what_was_published(measure):
    """4.0834 % of run 1, on which they were found, and 5.98 % of run 2."""
    declared = with_parameters(
        load(find_model("emps")),
        {"device.mass": 95.1089, "clutch.1.torque.coulomb": 20.3935,
         "clutch.1.torque.viscous": 203.5034},
    )  # fmt: skip
    published = replace(declared, effects=(BiasForce(bias=3.1648, coordinate=0),))
    runs = load_recording(DATA / "data.csv.gz", MAPS / "emps.toml").runs
    errors = [measure.relative_error(published, run) for run in runs]
    assert errors == pytest.approx([4.0834, 5.98], abs=5e-3)
