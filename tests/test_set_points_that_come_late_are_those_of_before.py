"""A servo whose set points come late does what it does with all of them shifted."""

from dataclasses import replace

import numpy as np
import pytest
from axis_recordings import declared_axis

from simpter_hybrid.compiled import simulate
from simpter_hybrid.identification.axis.drive import drive_candidates
from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.axis.set_points import DELAY, set_point_candidates
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.map_file import RecordingMap
from simpter_hybrid.identification.recordings.recording import RecordedRun, Recording
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.measuring.sampling import sample

TIME = np.arange(0.0, 3.0, 0.002)
LATE = 0.0134  # 6.7 rows of 2 ms


def servo(model, **changed):
    """The model with another servo."""
    ((stage, every),) = model.controllers
    return replace(model, controllers=((replace(stage, **changed), every),))


def angle(model):
    return sample(simulate(model), TIME).q[:, 0]


def test_late_set_points_are_points_that_stand_later():
    model = declared_axis()
    ((stage, _),) = model.controllers
    later = tuple((at + LATE, place) for at, place in stage.points)
    # Both read the same reference at the same instants: what differs is rounding.
    assert angle(servo(model, delay=LATE)) == pytest.approx(
        angle(servo(model, points=later)), abs=1e-9
    )


def test_a_record_is_followed_as_late_and_the_corrected_model_says_so():
    declared = declared_axis()
    wanted = np.interp(TIME, [0.0, 1.0], [0.0, 1.0])
    roles = {"position": "measured", "reference": "input"}
    channels = {n: ChannelMap(n, n, "rad", role) for n, role in roles.items()}
    moved = angle(servo(declared, delay=LATE))
    run = RecordedRun("run", "run", "run", (0, TIME.size), TIME,
                      {"position": moved, "reference": wanted})  # fmt: skip
    recording = Recording("file", RecordingMap("map", channels["position"], channels), (run,))
    replay = axis_replays(recording, AxisSignals())[0]
    (late,) = set_point_candidates(declared)
    predictor = ScenarioPredictor(declared, AxisRig(servo=True)).extended(late)
    values = {"Coulomb friction": 1.0, DELAY: LATE}
    told = predictor.predict(values, [replay])["position"][0]
    # The ramp's corner is rounded by less than the way of one row, 2 mrad, for one row.
    assert told == pytest.approx(moved, abs=2e-5)
    assert predictor.scenario(values).controllers[0][0].delay == LATE


def test_only_a_servo_that_stands_first_has_late_set_points():
    declared = declared_axis()
    (delayed,) = [c for c in drive_candidates(declared, False) if c.stages]
    other = replace(declared, controllers=((delayed.stages[0], 1), *declared.controllers))
    assert set_point_candidates(other) == ()
    assert set_point_candidates(replace(declared, controllers=())) == ()
