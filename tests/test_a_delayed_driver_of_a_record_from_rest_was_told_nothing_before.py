"""A record of an axis whose driver is late begins at rest, with its step in the first row."""

from dataclasses import replace

import numpy as np
from axis_recordings import MAP, declared_axis, written

from simpter_hybrid.compiled import simulate
from simpter_hybrid.controllers.axis_servo import PositionServo
from simpter_hybrid.controllers.drive_delay import DriveDelay
from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.measuring.sampling import sample

TIME = np.arange(0.0, 1.2, 0.004)
DELAY, TOLD, PERIOD = 0.04, 0.6, 0.002
#: Where it moves fast, long after the first step.
MOVING = 125


def _replay(folder, first):
    """Its record from row `first` on, told the same all the time."""
    pushing = PositionServo(((0.0, 1e6), (2.0, 1e6)), 1.0, limit=TOLD)
    stages = (pushing, 1), (DriveDelay(DELAY, from_rest=PERIOD), 1)
    driven = replace(declared_axis(), controllers=stages, t_end=1.2)
    q = sample(simulate(driven), TIME).q[first:, 0]
    rows = ["take,ms,angle,torque"]
    for take in range(3):
        at = zip(TIME[first:], q, strict=True)
        rows += [f"{take},{1e3 * t:.6g},{-np.degrees(a):.6f},{TOLD}" for t, a in at]
    described = MAP.replace('"lbf*in"\nsign = 1\nrole', '"N*m"\nheld = "after"\nsign = 1\nrole')
    return axis_replays(written(folder, rows, described), AxisSignals())[0]


def _off(replay, rig):
    """How far the true model's first window ends off [rad]."""
    declared = declared_axis()
    late = replace(declared, controllers=(*declared.controllers, (DriveDelay(DELAY), 1)))
    predictor = ScenarioPredictor(late, rig)
    values = {p.name: p.value for p in predictor.parameters}
    end = replay.restarts[0].index - 1
    told = predictor.predict(values, [replay])["position"][0]
    return abs(told[end] - replay.observed["position"].values[end])


class Unaware(AxisRig):
    """Begins every driver as if the first row had been told for long."""

    def told_nothing_before(self, replay):
        return ()


def test_the_true_model_predicts_its_first_window(tmp_path):
    replay = _replay(tmp_path, 0)
    right, wrong = _off(replay, AxisRig()), _off(replay, Unaware())
    assert right < 2e-4  # an error of the start grows
    assert wrong > 0.05


def test_one_that_begins_in_motion_had_been_told_its_first_row(tmp_path):
    replay = _replay(tmp_path, MOVING)
    assert AxisRig().told_nothing_before(replay) == ()
    assert _off(replay, AxisRig()) == _off(replay, Unaware())


def test_only_a_first_drive_under_which_it_leaves_is_new(tmp_path):
    replay = _replay(tmp_path, 0)
    assert AxisRig().told_nothing_before(replay) == (0,)
    untold = replay.inputs["drive"].copy()
    untold[0] = 0.0
    begun = replace(replay, inputs={**replay.inputs, "drive": untold})
    assert AxisRig().told_nothing_before(begun) == ()
    stands = {**replay.notes, "position": np.where(replay.time < 0.5, 0.0, 1.0)}
    lifted = {**replay.inputs, "drive": np.where(replay.time < 0.5, TOLD, 1.2 * TOLD)}
    assert AxisRig().told_nothing_before(replace(replay, notes=stands, inputs=lifted)) == ()
