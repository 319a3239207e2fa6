"""Rigs keep motions in shapes of their own: no remark of a report may fail at one of them."""

from dataclasses import replace

import numpy as np
import pytest
from two_joints import declared_joints, recorded_joints

from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.held_out_predictions import held_out_predictions
from simpter_hybrid.identification.maps import find_map, find_model
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.identification.reporting.data import diagnosis_data

KINDS = ("unknown", "lack or noise", "form incomplete", "effect", "cannot be told apart")
#: What is said goes by these: what grows in a run, and where it may come again.
LEFT = ("time", "heat", "distance", "position", "slip_velocity")


def _recorded_tip(folder):
    """Four runs of the robot that swing less and less, and tremble at 10 Hz."""
    t = np.arange(0.0, 4.5, 0.01)
    swing = np.exp(-0.3 * t) * np.sin(4.0 * t) + 0.02 * np.sin(62.8 * t)
    noise = np.random.default_rng(1)
    rows = ["run[1],t[s]," + ",".join(f"command_{i + 1}[V]" for i in range(4))
            + ",force_x[lbf],force_y[lbf],theta_1[rad],theta_2[rad]"]  # fmt: skip
    for run in range(8):
        angles = np.array([[1.2], [2.0]]) + 0.2 * swing + 4e-4 * noise.normal(size=(2, t.size))
        pushed = 5.0 * swing + 0.05 * noise.normal(size=(2, t.size))
        rows += [
            f"{run + 1},{s:.3f},0,0,0,0,{x:.4f},{y:.4f},{a:.6f},{b:.6f}"
            for s, x, y, a, b in zip(t, *pushed, *angles, strict=True)
        ]
    (folder / "tip.csv").write_text("\n".join(rows))
    recording = load_recording(folder / "tip.csv", find_map("robot", "", ""))
    return recording, load(find_model("robot"))


def _recorded_joints(folder):
    return recorded_joints(folder, declared_joints(), t_end=3.6, pieces=3), declared_joints()


@pytest.mark.parametrize(
    "recorded", [pytest.param(_recorded_tip, marks=pytest.mark.slow), _recorded_joints]
)
def test_nothing_fails(tmp_path, recorded):
    found = diagnose(*recorded(tmp_path), candidates=(), ended=lambda: True)
    told = held_out_predictions(found)
    for kind in KINDS:
        left = tuple(f"joint_{j}:{c}" for j in (1, 2) for c in LEFT)
        verdict = replace(found.search.verdict, kind=kind, coordinates=left)
        asked = replace(found, search=replace(found.search, verdict=verdict))
        data = diagnosis_data(asked, asked.recording, told, None)
        assert data["sentence"]
