"""Delays and thresholds that effects change are those of a planned run as well."""

from dataclasses import replace

import numpy as np
from robot_replays import declared

from simpter_hybrid.effects.pull_in import PullIn
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.identification.tip.experiments import TipReach
from simpter_hybrid.identification.tip.plan import planned_recording
from simpter_hybrid.identification.tip.rig import TipSignals

UNITS = {"position": ("rad", "measured"), "command": ("V", "input"), "force": ("N", "input")}
REACH = TipReach(
    middle=np.array([1.2, 2.0]), span=np.array([0.2, 0.3]), speed=np.array([0.7, 0.9]),
    slip=np.array([[1.0, 0.0], [0.0, 1.0], [1.0, -1.0], [1.0, 1.0]]), force=40.0,
    commands=np.full(4, 3.0), duration=0.6, step=4e-3,
)  # fmt: skip


def recorded(folder):
    names = TipSignals().of(declared().device)
    text = '[time]\ncolumn = "t"\nunit = "s"\n'
    for name in names:
        unit, role = UNITS[name.rpartition("_")[0]]
        text += f'[channels.{name}]\ncolumn = "{name}"\nunit = "{unit}"\nsign = 1\n'
        text += f'role = "{role}"\nnoise = "1e-4 {unit}"\n'
    rows = [",".join(["t", *names])]
    rows += [",".join([f"{0.004 * k}", *(f"{0.01 * k}" for _ in names)]) for k in range(100)]
    (folder / "data.csv").write_text("\n".join(rows), encoding="utf-8")
    (folder / "map.toml").write_text(text, encoding="utf-8")
    return load_recording(folder / "data.csv", folder / "map.toml")


def test_a_pull_in_delays_as_a_longer_delay_does(tmp_path):
    recording, model = recorded(tmp_path), declared()
    slow = tuple(replace(c, delay=c.delay + 0.2) for c in model.clutches)
    late = replace(model, effects=tuple(PullIn(clutch=i, extra=0.2) for i in range(4)))
    every = [planned_recording(recording, m, REACH)[0].runs
             for m in (late, replace(model, clutches=slow), model)]  # fmt: skip
    moved = [np.concatenate([r.channels["position_1"] for r in runs]) for runs in every]
    # Both take the same steps, and the same noise is added.
    np.testing.assert_allclose(moved[0], moved[1], atol=1e-12)
    assert np.abs(moved[2] - moved[1]).max() > 1e-4
