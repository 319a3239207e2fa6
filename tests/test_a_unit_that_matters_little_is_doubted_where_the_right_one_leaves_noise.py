"""Friction hardly asks how fast: a tester's way in millimetres, read as metres, still has its sign.

Without any motion the declared model errs little more than with the right unit, so the unit is no
half of the error; but with it the model as declared leaves noise alone.
"""

import numpy as np
import pytest
from moved_axis import DRIVEN, MAP, model

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.benches import bench_of
from simpter_hybrid.identification.deviations import scaled
from simpter_hybrid.identification.doubted_channels import doubted_channels
from simpter_hybrid.identification.fitting.residual import rms, weighted_residuals
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.recordings.recording import load_recording

MASS, COULOMB, VISCOUS, NOISE = 0.05, 3.0, 1.0, 0.1
DECLARED = parse(model(MASS, 'coulomb = "3 N", viscous = "1 N*s/m"') + DRIVEN)


@pytest.mark.parametrize(("unit", "asked"), [("m", True), ("mm", False)])
def test_the_unit_is_asked_for_and_the_right_one_is_not(tmp_path, unit, asked):
    generator, rows = np.random.default_rng(2), ["run,t,x,F"]
    for run in range(3):
        for t in np.arange(0.0, 5.0, 0.01):
            at = (2.0 + run) * t
            x, v, a = (0.1 * (2.0 + run) ** k * f for k, f in enumerate(
                (np.sin(at) / 2.0, np.cos(at) / 2.0, -np.sin(at) / 2.0)))  # fmt: skip
            force = MASS * a + COULOMB * np.sign(v) + VISCOUS * v + NOISE * generator.normal()
            rows.append(f"{run},{t:.2f},{1e3 * x:.5f},{force:.4f}")
    (tmp_path / "data.csv").write_text("\n".join(rows), encoding="utf-8")
    (tmp_path / "map.toml").write_text(MAP.replace('"m"', f'"{unit}"'), encoding="utf-8")
    recording = load_recording(tmp_path / "data.csv", tmp_path / "map.toml")
    bench = bench_of(recording, DECLARED, groups_of(recording))
    values = {p.name: p.value for p in bench.predictor.parameters}
    runs = scaled(bench.parts, bench.predictor, values)
    error = rms(weighted_residuals(bench.predictor, values, runs["select"]))
    seen = [s for r in runs["select"] for s in r.observed.values()]
    floor = NOISE / seen[0].sd
    found = doubted_channels(bench, recording, values, runs["select"], error, floor)
    said = {doubt.change.channels: doubt.change.factor for doubt in found}
    assert said == ({("position",): pytest.approx(1e-3)} if asked else {})
