"""A record that begins in motion begins with a driver that has followed what it was told."""

from dataclasses import replace

import numpy as np
import pytest
from axis_recordings import MAP, declared_axis, written

from simpter_hybrid.compiled import simulate
from simpter_hybrid.effects.drive_lag import DriveLag
from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.loads.recorded_force import RecordedForce
from simpter_hybrid.measuring.sampling import sample

TIME = np.arange(0.0, 3.16, 0.004)
LAG, TOLD = 0.05, 0.6
#: Where it moves fast, ten time constants after the first step.
MOVING = 125


def _late():
    effect = DriveLag(coordinate=0, lag=LAG, constant=1.0)
    return replace(declared_axis(), effects=(effect,))


def _followed():
    """What the driver does: told 0.6 V from the start on, and -0.6 V after 3 s."""
    rising = TOLD * (1.0 - np.exp(-TIME / LAG))
    back = -TOLD + 2.0 * TOLD * np.exp(-(TIME - 3.0) / LAG)
    return np.where(TIME < 3.0, rising, back)


def _replay(folder, first):
    """Its record from row `first` on."""
    course = tuple(zip(TIME.tolist(), _followed().tolist(), strict=True))
    acts = RecordedForce(course, coordinate=0)
    driven = replace(declared_axis(), loads=(acts,), controllers=(), t_end=3.16)
    q = sample(simulate(driven), TIME).q[:, 0]
    told = np.where(TIME < 3.0 - 1e-9, TOLD, -TOLD)
    rows = ["take,ms,angle,torque"]
    for take in range(3):
        rows += [
            f"{take},{1e3 * t:.6g},{-np.degrees(a):.6f},{u:.6g}"
            for t, a, u in zip(TIME[first:], q[first:], told[first:], strict=True)
        ]
    described = MAP.replace('"lbf*in"\nsign = 1\nrole', '"N*m"\nheld = "after"\nsign = 1\nrole')
    return axis_replays(written(folder, rows, described), AxisSignals())[0]


def _off(replay, rig):
    """How far the true model's first window ends off [rad]."""
    predictor = ScenarioPredictor(_late(), rig)
    values = {p.name: p.value for p in predictor.parameters}
    end = replay.restarts[0].index - 1
    told = predictor.predict(values, [replay])["position"][0]
    return abs(told[end] - replay.observed["position"].values[end])


class Unaware(AxisRig):
    """Begins every driver with nothing told, as at rest."""

    def told_in_motion(self, replay):
        return {}


@pytest.mark.parametrize("first", [0, MOVING])
def test_the_true_model_predicts_its_first_window(first, tmp_path):
    # From rest it had been told nothing.  A start's error grows to 0.04 mrad.
    assert _off(_replay(tmp_path, first), AxisRig()) < 2e-4


def test_with_nothing_told_before_it_would_be_far_off(tmp_path):
    assert _off(_replay(tmp_path, MOVING), Unaware()) > 0.1


def test_a_released_drive_had_told_nothing(tmp_path):
    moving = _replay(tmp_path, MOVING)
    assert AxisRig().told_in_motion(moving) == {0: pytest.approx(TOLD)}
    open_ends = {**moving.inputs, "released": np.ones(moving.time.size)}
    assert AxisRig().told_in_motion(replace(moving, inputs=open_ends)) == {}
