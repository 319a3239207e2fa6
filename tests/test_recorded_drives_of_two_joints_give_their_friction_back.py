"""A two-link arm run by the reference engine is a recording; its replay finds the friction."""

from dataclasses import replace

import numpy as np
import pytest

from simpter_hybrid.engine import simulate
from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.identification.axis.joints_rig import JointsRig, joint_replays
from simpter_hybrid.identification.fitting.fit import Fitter
from simpter_hybrid.identification.maps import find_model
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.identification.rigs.corrected import with_parameters
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.loads.recorded_force import RecordedForce
from simpter_hybrid.measuring.sampling import sample

TRUE = {"clutch.1.torque.coulomb": 0.12, "clutch.2.torque.coulomb": 0.05}
CHANNEL = '[channels.{name}]\ncolumn = "{name}"\nunit = "{unit}"\nsign = 1\nrole = "{role}"\n'


def written(folder, times, columns):
    """CSV and map of one run."""
    names = list(columns)
    rows = [",".join(["t", *names])]
    values = np.column_stack([columns[n] for n in names])
    rows += [
        f"{t:.4f}," + ",".join(f"{v:.9g}" for v in row)
        for t, row in zip(times, values, strict=True)
    ]
    units = {"position": ("rad", "measured"), "speed": ("rad/s", "measured"),
             "torque": ("N*m", "input")}  # fmt: skip
    text = '[time]\ncolumn = "t"\nunit = "s"\n'
    for name in names:
        unit, role = units[name.rpartition("_")[0]]
        text += CHANNEL.format(name=name, unit=unit, role=role)
    (folder / "data.csv").write_text("\n".join(rows), encoding="utf-8")
    (folder / "map.toml").write_text(text, encoding="utf-8")
    return load_recording(folder / "data.csv", folder / "map.toml")


@pytest.mark.slow
def test_friction_of_both_joints_comes_back(tmp_path):
    declared = load(find_model("dfki_double_pendulum"))
    times = np.arange(0.0, 1.6, 0.005)
    drives = 1.2 * np.sin(4.0 * times), 0.6 * np.sin(7.0 * times + 1.0)
    loads = tuple(
        RecordedForce(tuple(zip(times.tolist(), d.tolist(), strict=True)), coordinate=j)
        for j, d in enumerate(drives)
    )
    true = replace(with_parameters(declared, TRUE), loads=loads, controllers=(), t_end=1.59)
    seen = sample(simulate(true), times[times < 1.59])
    columns = {}
    for j in range(2):
        columns |= {f"position_{j + 1}": seen.q[:, j], f"speed_{j + 1}": seen.qd[:, j]}
        columns[f"torque_{j + 1}"] = drives[j][: seen.q.shape[0]]
    replays = joint_replays(written(tmp_path, seen.t, columns))
    predictor = ScenarioPredictor(declared, JointsRig())
    near = {p.name: 1.0 for p in predictor.parameters}
    near |= {"Coulomb friction of the shoulder": 1.4, "Coulomb friction of the elbow": 0.7}
    found = Fitter(predictor, replays).fit(near, iterations=20).values
    # The drive is held for 2 ms in the replay and straight in the run; starts of windows come from
    # local parabolas: together some 1e-3 of 0.08 N m, with a margin of ten.
    assert 0.08 * found["Coulomb friction of the shoulder"] == pytest.approx(0.12, rel=0.02)
    assert 0.08 * found["Coulomb friction of the elbow"] == pytest.approx(0.05, rel=0.02)
