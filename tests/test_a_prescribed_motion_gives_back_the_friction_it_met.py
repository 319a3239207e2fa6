"""A tester moves a coordinate as recorded: the force it took gives the friction back."""

import numpy as np
import pytest
from moved_axis import DRIVEN, MAP, model

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.axis.prescribed_replays import prescribed_replays
from simpter_hybrid.identification.axis.prescribed_rig import PrescribedRig
from simpter_hybrid.identification.deviations import scaled
from simpter_hybrid.identification.fitting.fit import Fitter
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor

MASS, AREA = 2.0, 3e-4
MODEL = model(MASS, 'coulomb = "3 N", viscous = "10 N*s/m", normal = "8e-6 N/V"')
MODEL += f"""{DRIVEN}
[[loads]]
kind = "piston-force"
area = "{AREA} N/V"
[[tolerances]]
name = "pressure"
parameters = ["clutch.1.torque.normal"]
relative = 0.5
[[tolerances]]
name = "viscous"
parameters = ["clutch.1.torque.viscous"]
relative = 0.5
"""
PRESSED = """
noise = "0.05 N"
[channels.pressure]
column = "p"
unit = "Pa"
sign = 1
role = "input"
"""


def test_coulomb_viscous_and_pressure_come_back_from_a_sinusoid(tmp_path):
    generator = np.random.default_rng(3)
    rows = ["run,t,x,p,F"]
    for run, (frequency, pressure) in enumerate(((0.3, 1e5), (0.6, 4e5))):
        t = np.arange(0.0, 6.0, 0.02)
        turn = 2 * np.pi * frequency
        speed = 0.03 * turn * np.cos(turn * t)
        friction = np.sign(speed) * (4.0 + 6e-6 * pressure + 14.0 * np.abs(speed))
        inertial = -MASS * 0.03 * turn**2 * np.sin(turn * t)
        force = friction + inertial + AREA * pressure + generator.normal(0.0, 0.05, t.size)
        for row in zip(t, 0.03 * np.sin(turn * t), force, strict=True):
            rows.append(f"{run},{row[0]:.2f},{row[1]:.8f},{pressure},{row[2]:.5f}")
    (tmp_path / "data.csv").write_text("\n".join(rows), encoding="utf-8")
    (tmp_path / "map.toml").write_text(MAP + PRESSED, encoding="utf-8")
    replays = prescribed_replays(load_recording(tmp_path / "data.csv", tmp_path / "map.toml"))
    predictor = ScenarioPredictor(parse(MODEL), PrescribedRig())
    nominal = {p.name: 1.0 for p in predictor.parameters}
    # Against noise alone every residual of the declared model would be clipped.
    parts = scaled({"fit": replays}, predictor, nominal)
    near = Fitter(predictor, parts["fit"]).fit(nominal).values
    found = Fitter(predictor, replays).fit(near).values
    # 450 samples of 0.05 N: 3 standard deviations are 0.01 N of a level and, with speeds that vary
    # by 0.03 m/s, 0.24 N s/m of the slope.
    assert 3.0 * found["Coulomb"] == pytest.approx(4.0, abs=0.02)
    assert 8e-6 * found["pressure"] == pytest.approx(6e-6, rel=0.01)
    assert 10.0 * found["viscous"] == pytest.approx(14.0, abs=0.24)
