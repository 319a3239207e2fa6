"""Tip loads, freed numbers and sensors as candidates: two routes to the same prediction."""

from dataclasses import replace

import numpy as np
import pytest
import robot_replays as robot

from simpter_hybrid.devices.planar_arm import PlanarArm
from simpter_hybrid.engine import simulate
from simpter_hybrid.identification.fitting.replay import Observation
from simpter_hybrid.identification.fitting.residual import deviation
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.identification.tip.rig import TipRig, TipSignals
from simpter_hybrid.identification.tip.sensors import read_angles, sensed
from simpter_hybrid.identification.tip.structure import Scales, structure_candidates
from simpter_hybrid.loads.tip_spring import TipDrag, TipSpring
from simpter_hybrid.measuring.readings import force_axes
from simpter_hybrid.measuring.sampling import sample


def _end(scenario, extra=()):
    loads = (*scenario.loads, *extra)
    run = simulate(replace(scenario, loads=loads, t_end=0.5, rtol=1e-9, atol=1e-11))
    return sample(run, np.array([0.5])).q[0]


@pytest.mark.parametrize("name", ["tip-spring", "tip-drag", "tilt"])
def test_a_tip_load_in_a_replay_is_the_load_of_a_scenario(name):
    declared, candidate = robot.declared(), robot.candidates()[name]
    predictor = ScenarioPredictor(declared, TipRig()).extended(candidate)
    values = {p.name: p.value for p in predictor.parameters}
    values |= {p.name: 5 * p.typical for p in candidate.parameters}
    made = candidate.made_load(values)
    assert predictor.scenario(values).loads[-1] == made[0]
    # The load stands in the parameter vector where its fit's values go.
    p, _ = predictor.vector(values)
    for fitted, own in candidate.fields():
        assert p[predictor.runner.names[f"load.2.{own}"]] == values[fitted]


def test_a_payload_is_what_a_mass_on_the_tip_adds_to_all_three_inertias():
    declared, candidate = robot.declared(), robot.candidates()["payload"]
    pter, mass = declared.device, 2.0
    a, d = pter.l_a, pter.l_d
    heavier = replace(
        pter, alpha=pter.alpha + 0.5 * mass * a * a, beta=pter.beta + 0.5 * mass * d * d,
        gamma=pter.gamma - mass * a * d,
    )  # fmt: skip
    told = {p.name: p.value for p in ScenarioPredictor(declared, TipRig()).parameters}
    found = []
    for predictor in (
        ScenarioPredictor(declared, TipRig()).extended(candidate),
        ScenarioPredictor(replace(declared, device=heavier), TipRig()),
        ScenarioPredictor(declared, TipRig()),
    ):
        predicted = predictor.predict(told | {"payload.mass": mass}, [robot.replay()])
        found.append(np.concatenate([predicted[f"position_{j + 1}"][0] for j in range(2)]))
    # Replays are integrated to 1e-7.
    assert found[0] == pytest.approx(found[1], abs=1e-7)
    assert np.abs(found[0] - found[2]).max() > 1e-4


def test_a_payload_is_tried_on_any_device_with_a_tip():
    model = robot.declared()
    arm = replace(model, device=PlanarArm(), clutches=(model.clutches[0],) * 5)
    assert "payload" in {c.name for c in structure_candidates(arm, Scales(20.0, 0.5, 0.5, 2.0))}


def test_a_force_is_put_right_and_an_angle_is_read_as_the_sensors_would():
    values = {"force-turned.angle": 0.2, "angle-gain.1.gain": 0.1, "angle-gain.1.offset": 0.05}
    values |= {"angle-gain.2.gain": 0.0, "angle-gain.2.offset": 0.0}
    run = robot.replay()
    seen = sensed(run, values, TipSignals())
    before = run.inputs["force_x"] + 1j * run.inputs["force_y"]
    after = seen.inputs["force_x"] + 1j * seen.inputs["force_y"]
    assert after == pytest.approx(before * np.exp(-0.2j))
    mixed = {"force-crosstalk.x": 0.1, "force-crosstalk.y": -0.3}
    put_right = sensed(run, {**values, **mixed}, TipSignals())
    true = np.array([put_right.inputs["force_x"], put_right.inputs["force_y"]])
    shown = force_axes(0.2, 0.1, -0.3) @ true
    assert shown == pytest.approx(np.array([run.inputs["force_x"], run.inputs["force_y"]]))
    channels = {f"position_{j + 1}": seen.notes["position"][j].copy() for j in range(2)}
    read_angles(run, values, channels, "position")
    assert channels["position_1"] == pytest.approx(run.notes["position"][0])
    assert sensed(run, {"torque scale 1": 1.0}, TipSignals()) is run


def test_a_residual_along_a_curve_of_noise_counts_for_less():
    line = np.linspace(-1, 1, 50)
    curve = line**2 - np.polyval(np.polyfit(line, line**2, 1), line)
    curve /= np.linalg.norm(curve)
    seen = Observation(
        7.0 * curve, 1.0, np.ones(50, bool), 1.0, (0,), ((curve[:, None], np.array([0.75])),)
    )
    nothing = np.zeros(50)
    assert deviation(seen, nothing) == pytest.approx(0.25 * 7.0 * curve)
    assert deviation(seen, nothing, weighed=False) == pytest.approx(7.0 * curve)


def test_a_tip_spring_pulls_to_its_rest_and_drag_takes_energy():
    pulled = _end(robot.declared(), (TipSpring(100.0, 0.0, 0.0),))
    free = _end(robot.declared())
    device = robot.declared().device
    tips = []
    for q in (pulled, free):
        out = [0.0, 0.0]
        device.tip(list(q), list(device.parameters().values()), out)
        tips.append(np.hypot(*out))
    assert tips[0] < tips[1]
    slow = _end(robot.declared(), (TipDrag(200.0),))
    start = np.array([1.2, 2.0])
    assert np.abs(slow - start).max() < np.abs(free - start).max()
