"""Replays of a device with a tip: two engines, two ways to feed forces and commands."""

from dataclasses import replace

import numpy as np

from simpter_hybrid.controllers.profile import CommandProfile
from simpter_hybrid.engine import simulate
from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.fitting.residual import deviation, without_line
from simpter_hybrid.identification.maps import find_model
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.identification.rigs.start_state import state_at_zero
from simpter_hybrid.identification.tip.rig import TipRig
from simpter_hybrid.loads.recorded import RecordedTipForce
from simpter_hybrid.measuring.sampling import sample

TIME = np.arange(601) * 0.002
#: As the record begins, so it was commanded before.
BEGUN = (2.0, 0.0, 0.0, 0.0)
STEPS = (((0.0, 2.0), (0.4, 2.0), (0.4, 0.0)), ((0.0, 0.0), (0.2, 0.0), (0.2, 5.0)))


def force(t):
    return 40.0 * np.sin(5.0 * t), 30.0 * np.sin(3.0 * t + 1.0) - 25.0


def reference(declared):
    """The run by the reference engine, from parts that files have."""
    x, y = force(TIME)
    points = tuple(zip(TIME.tolist(), x.tolist(), y.tolist(), strict=True))
    stages = tuple((CommandProfile(p, k), 1) for k, p in zip((0, 2), STEPS, strict=True))
    made = replace(
        declared, controllers=stages, loads=(RecordedTipForce(points),), t_end=1.2, stops=(),
        rtol=1e-9, atol=1e-11, command=BEGUN, excitation=BEGUN,
    )  # fmt: skip
    run = simulate(made)
    assert run.status == "finished"
    return sample(run, TIME).q


def recorded(declared, q):
    commands = {f"command_{k + 1}": np.zeros(TIME.size) for k in range(4)}
    for k, points in zip((1, 3), STEPS, strict=True):
        jump, before, after = points[2][0], points[0][1], points[2][1]
        commands[f"command_{k}"] = np.where(jump - 1e-9 <= TIME, after, before)
    x, y = force(TIME)
    inputs = commands | {"force_x": x, "force_y": y}
    every = np.ones(TIME.size, bool)
    observed = {f"position_{j + 1}": Observation(q[:, j], 1e-4, every) for j in range(2)}
    notes = {"start_at": np.zeros(1, int), "states": np.array([[*declared.q, 0.0, 0.0]])}
    return Replay("run", "run", TIME, inputs, observed, notes=notes)


def test_a_replay_repeats_the_reference_engine():
    declared = load(find_model("robot"))
    q = reference(declared)
    assert np.ptp(q, axis=0).min() > 0.04
    predictor = ScenarioPredictor(declared, TipRig())
    values = {p.name: p.value for p in predictor.parameters}
    found = predictor.predict(values, [recorded(declared, q)])
    for j in range(2):
        # Forces are smoothed over 18 ms: a parabola misses a sine of 5 rad/s by 1e-5 of 40 N.
        assert np.abs(found[f"position_{j + 1}"][0] - q[:, j]).max() < 2e-5


def test_an_error_of_a_windows_start_is_not_an_error_of_the_model():
    line = np.concatenate([0.3 + 0.1 * np.arange(40), -0.2 * np.arange(60.0)])
    bent = np.zeros(100)
    bent[40:] = 1e-3 * np.arange(60) ** 2
    every = np.ones(100, bool)
    seen = Observation(line + bent, 1.0, every, 1.0, (0, 40))
    error = deviation(seen, np.zeros(100))
    assert np.abs(error[:40]).max() < 1e-12
    # Least squares: what is left of a parabola's bend is orthogonal to any line.
    assert np.abs(error[40:]).max() > 0.1
    assert abs(error[40:] @ np.arange(60)) < 1e-9
    assert np.allclose(without_line(error[40:]), error[40:])


def test_a_start_that_noise_alone_would_give_is_rest():
    noise = np.random.default_rng(3).normal(0.0, 1e-3, 51)
    t = 0.002 * np.arange(-25, 26)
    assert state_at_zero(t, noise, 1e-3, 2)[1] == 0.0
    moving = noise + 0.4 * t
    # Standard deviation of the speed: 1e-3 sqrt(12/51^3)/0.002 = 5 mrad/s.
    assert abs(state_at_zero(t, moving, 1e-3, 2)[1] - 0.4) < 0.02
