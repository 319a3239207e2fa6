"""A heavy coordinate is moved to and fro: what its inertia takes is known, and nothing is left."""

import numpy as np
import pytest

from simpter_hybrid.identification.prescribed_rig import PrescribedRig, prescribed_replays
from simpter_hybrid.identification.recording import load_recording
from simpter_hybrid.identification.scenario_predictor import ScenarioPredictor
from simpter_hybrid.identification.smoothing import degree_of_motion, derivative
from simpter_hybrid.scenario_file import parse

MASS, VISCOUS, STEP = 3.0, 8.0, 0.005
MODEL = f"""
[run]
t_end = "5 s"
[device]
kind = "linear-axis"
mass = "{MASS} kg"
[start]
coordinates = ["0 m"]
[clutch]
time_constant = "0 s"
delay = "0 s"
threshold = "-1 V"
torque = {{ kind = "coulomb-viscous", coulomb = "2 N", viscous = "{VISCOUS} N*s/m" }}
[[loads]]
kind = "force-drive"
constant = "1 N/V"
[controller]
rate = "1 kHz"
[[controller.stages]]
kind = "position-servo"
points = [["0 s", "0 m"], ["1 s", "0 m"]]
proportional = "1 V/m"
limit = "1 V"
[[tolerances]]
name = "Coulomb"
parameters = ["clutch.1.torque.coulomb"]
relative = 0.5
"""
MAP = """
[time]
column = "t"
unit = "s"
[channels.position]
column = "x"
unit = "m"
sign = 1
role = "input"
[channels.force]
column = "F"
unit = "N"
sign = 1
role = "measured"
"""


def _motion():
    """Time, position, speed and acceleration of 1.4 Hz: 75 ms of it are a tenth of a turn."""
    t, turn = np.arange(0.0, 8.0, STEP), 2 * np.pi * 1.4
    x = 0.03 * np.sin(turn * t)
    return t, x, 0.03 * turn * np.cos(turn * t), -(turn**2) * x


def test_the_force_is_that_of_inertia_and_friction_at_each_sample(tmp_path):
    t, x, v, a = _motion()
    force = MASS * a + 2.0 * np.sign(v) + VISCOUS * v
    rows = ["t,x,F", *(f"{i:.3f},{j:.9f},{k:.6f}" for i, j, k in zip(t, x, force, strict=True))]
    (tmp_path / "data.csv").write_text("\n".join(rows), encoding="utf-8")
    (tmp_path / "map.toml").write_text(MAP, encoding="utf-8")
    (replay,) = prescribed_replays(load_recording(tmp_path / "data.csv", tmp_path / "map.toml"))
    told = ScenarioPredictor(parse(MODEL), PrescribedRig()).predict({"Coulomb": 1.0}, [replay])
    seen = replay.observed["force"]
    left = (seen.values - told["force"][0])[seen.keep]
    # Inertia takes up to 7 N, drag changes by up to 0.1 N from one sample to the next: of neither
    # a thousandth is lost (quartics over 75 ms lose 1e-4).
    assert np.abs(left).max() < 1e-3 * MASS * np.abs(a).max()


@pytest.mark.parametrize(("noise", "degree"), [(1e-7, 4), (3e-4, 2)])
def test_quartics_only_where_noise_does_not_drown_what_they_see(noise, degree):
    x = _motion()[1]
    seen = x + np.random.default_rng(1).normal(0.0, noise, x.size)
    assert degree_of_motion(seen, STEP, 0.075) == degree


def test_parabolas_would_lose_one_part_in_a_hundred():
    _, x, v, _ = _motion()
    inside = slice(20, -20)
    lost = {d: np.abs(derivative(x, STEP, 0.075, d) - v)[inside].max() / v.max() for d in (2, 4)}
    assert lost[2] > 0.008 > 1e-4 > lost[4]
