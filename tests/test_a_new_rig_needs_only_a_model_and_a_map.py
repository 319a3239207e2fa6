"""An axis that nobody has written code for, in its own units, is diagnosed by two TOML files."""

from dataclasses import replace

import numpy as np
import pytest

from simpter_hybrid.compiled import simulate
from simpter_hybrid.effects.asymmetry import Asymmetry
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.recording import load_recording
from simpter_hybrid.loads.recorded_force import RecordedForce
from simpter_hybrid.sampling import sample
from simpter_hybrid.scenario_file import parse

MODEL = """
[run]
t_end = "4 s"
[device]
kind = "one-axis"
inertia = "0.02 kg*m^2"
weight = "0.5 N*m"
[start]
coordinates = ["0 rad"]
[clutch]
time_constant = "0 s"
delay = "0 s"
threshold = "-1 V"
torque = { kind = "coulomb-viscous", coulomb = "0.2 N*m", viscous = "0.02 N*m*s/rad" }
[[loads]]
kind = "force-drive"
constant = "1 N*m/V"
[controller]
rate = "500 Hz"
[[controller.stages]]
kind = "position-servo"
points = [["0 s", "0 rad"], ["1 s", "1 rad"]]
proportional = "1 V/rad"
limit = "1 V"
[[tolerances]]
name = "Coulomb friction"
parameters = ["clutch.1.torque.coulomb"]
relative = 0.2
"""
MAP = """
[time]
column = "ms"
unit = "ms"
[runs]
boundaries = ["take"]
group = ["take"]
[split]
fit = ["take 0"]
select = ["take 1"]
report = ["take 2"]
[channels.position]
column = "angle"
unit = "deg"
sign = -1
role = "measured"
may_rest = true
[channels.torque]
column = "torque"
unit = "lbf*in"
sign = 1
role = "input"
"""
NEWTON_METRES = 0.1129848290276167


@pytest.mark.slow
def test_friction_that_differs_with_direction_is_named(tmp_path):
    declared = parse(MODEL)
    lacking = replace(declared, effects=(Asymmetry(clutch=0, share=0.25),), controllers=())
    generator = np.random.default_rng(2)
    times, rows = np.arange(0.0, 4.0, 0.004), ["take,ms,angle,torque"]
    for take in range(3):
        drive = 0.9 * np.sin((2.0 + 0.5 * take) * times) + 0.4 * np.sin(5.3 * times + take)
        load = RecordedForce(tuple(zip(times.tolist(), drive.tolist(), strict=True)), coordinate=0)
        q = sample(simulate(replace(lacking, loads=(load,), t_end=4.0)), times).q[:, 0]
        q = q + generator.normal(0.0, 2e-4, times.size)
        rows += [
            f"{take},{1e3 * t:.1f},{-np.degrees(a):.5f},{u / NEWTON_METRES:.6f}"
            for t, a, u in zip(times, q, drive, strict=True)
        ]
    (tmp_path / "data.csv").write_text("\n".join(rows), encoding="utf-8")
    (tmp_path / "map.toml").write_text(MAP, encoding="utf-8")
    found = diagnose(load_recording(tmp_path / "data.csv", tmp_path / "map.toml"), declared)
    assert found.diagnosis.verdict.accepted.candidate.name == "asymmetry"
    share = found.diagnosis.corrected.values["asymmetry.share"]
    # Speeds come from noisy positions by parabolas over 30 ms: some per cent of friction.
    assert share == pytest.approx(0.25, abs=0.05)
    assert found.errors["after"]["speed"] < 0.5 * found.errors["refitted"]["speed"]
