"""Only the set point and the motion were logged: the model's own servo follows the record."""

from dataclasses import replace

import numpy as np
import pytest
from axis_recordings import declared_axis
from scipy.optimize import brentq

from simpter_hybrid.compiled import simulate
from simpter_hybrid.identification.axis.halves import halves
from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.fitting.residual import deviation
from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.map_file import RecordingMap
from simpter_hybrid.identification.recordings.recording import RecordedRun, Recording
from simpter_hybrid.identification.rigs.corrected import with_parameters
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.measuring.sampling import sample
from simpter_hybrid.problems import InvalidInput


def with_servo(**changed):
    """The declared axis with another servo."""
    model = declared_axis()
    ((servo, every),) = model.controllers
    return replace(model, controllers=((replace(servo, **changed), every),))


def recorded(model=None):
    """The servo's run without noise, every 2 ms."""
    time = np.arange(0.0, 4.0, 0.002)
    angle = sample(simulate(model or declared_axis()), time).q[:, 0]
    wanted = np.interp(time, [0.0, 1.0], [0.0, 1.0])
    roles = {"position": "measured", "reference": "input"}
    channels = {n: ChannelMap(n, n, "rad", role) for n, role in roles.items()}
    run = RecordedRun("run", "run", "run", (0, time.size), time,
                      {"position": angle, "reference": wanted})  # fmt: skip
    return Recording("file", RecordingMap("map", channels["position"], channels), (run,))


@pytest.mark.parametrize(
    "changed",
    [
        {},
        {"differenced": 1.0, "derivative": 0.1, "proportional": 2.0},
        {"integral_gain": 3.0, "proportional": 2.0, "limit": 3.0},
    ],
    ids=["plain", "differenced", "integral"],
)
def test_the_loop_gives_the_motion_back(changed):
    model = with_servo(**changed)
    replay = axis_replays(recorded(model), AxisSignals())[0]
    told = ScenarioPredictor(model, AxisRig(servo=True)).predict(
        {"Coulomb friction": 1.0}, [replay]
    )
    assert not replay.restarts  # the loop holds the run: a false start fades by itself
    # It starts at rest, and its samples are the rows: what is left is the tolerance of the runs.
    assert told["position"][0] == pytest.approx(replay.notes["position"], abs=1e-6)


def test_a_constant_error_counts():
    seen = axis_replays(recorded(), AxisSignals())[0].observed["position"]
    error = deviation(seen, seen.values - 1e-3)
    assert error == pytest.approx(np.full(error.size, 1e-3))  # no straight line is taken away


def test_one_run_gives_two_halves():
    halved = halves(axis_replays(recorded(), AxisSignals())[0])
    sizes = [half.time.size for half in halved]
    assert sum(sizes) == 2000
    assert min(sizes) >= 1000 - 63  # the second begins where the motion is smoothest: WINDOW / 4
    told = ScenarioPredictor(declared_axis(), AxisRig(servo=True)).predict(
        {"Coulomb friction": 1.0}, halved
    )
    for seen, half in zip(told["position"], halved, strict=True):
        assert seen == pytest.approx(half.notes["position"], abs=1e-6)


def test_an_integral_leaves_no_error_under_a_weight():
    slow = {"proportional": 2.0, "derivative": 0.5, "limit": 9.0}
    ends = []
    for gain in (0.0, 6.0):
        model = with_servo(integral_gain=gain, **slow)
        smooth = replace(
            with_parameters(model, {"clutch.1.torque.coulomb": 0.0}), t_end=30.0, q=(0.0,)
        )
        ends.append(float(sample(simulate(smooth), np.array([29.9])).q[0, 0]))
    # 0.5 N m sin q = 2 N m/rad (1 rad - q) without; every pole of the loop is left of -1/s.
    without = brentq(lambda q: 2.0 * (1.0 - q) - 0.5 * np.sin(q), 0.0, 1.0)
    assert ends == pytest.approx([without, 1.0], abs=1e-6)


def test_a_model_without_a_servo_is_told_what_it_needs():
    with pytest.raises(InvalidInput, match="position-servo"):
        AxisRig(servo=True).template(replace(declared_axis(), controllers=()))
