"""Set points, a motion from outside, a release: told by the model, replayed like records."""

import numpy as np
import pytest
from axis_recordings import MAP, declared_axis, recorded_axis

from simpter_hybrid.identification.axis.recorded import as_axis
from simpter_hybrid.identification.axis.told_plan import LET_GO
from simpter_hybrid.identification.benches import bench_of
from simpter_hybrid.identification.fitting.residual import deviation
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.recordings.recording import load_recording

MOTION, _, DRIVE = MAP.partition("[channels.torque]")
MAPS = {
    "slow strokes both ways": f"{MOTION}[channels.reference]{DRIVE}".replace("lbf*in", "deg"),
    "slow strokes at both ends and in the middle": MOTION.replace("measured", "input")
    + f"[channels.force]{DRIVE}".replace("input", "measured").replace("lbf*in", "N*m")
    .replace("N*m", "lbf*in"),
    "let go at the largest speed": f"driven = false\n{MOTION}",
}  # fmt: skip


@pytest.mark.parametrize("name", MAPS)
def test_what_is_planned_is_predicted_to_the_noise(name, tmp_path):
    recorded_axis(tmp_path, [])
    (tmp_path / "map.toml").write_text(MAPS[name], encoding="utf-8")
    recording = as_axis(load_recording(tmp_path / "data.csv", tmp_path / "map.toml"))
    bench = bench_of(recording, declared_axis(), groups_of(recording))
    values = {p.name: p.value for p in bench.predictor.parameters}
    runs = bench.experiments(values, bench.parts["select"])
    assert name in [run.name for run in runs]
    predicted = bench.predictor.predict(values, runs)
    for i, run in enumerate(runs):
        ((channel, seen),) = run.observed.items()
        # Less what noise makes of a start, which one side of it tells: as a fit weighs it.
        error = deviation(seen, predicted[channel][i])
        # 0.7 for noise alone, more with what is left of a start.
        assert np.median(np.abs(error)) < 2.5 * seen.sd


def test_a_planned_release_begins_where_it_was_planned(tmp_path):
    recorded_axis(tmp_path, [])
    described = MAPS["let go at the largest speed"]
    (tmp_path / "map.toml").write_text(described, encoding="utf-8")
    recording = as_axis(load_recording(tmp_path / "data.csv", tmp_path / "map.toml"))
    bench = bench_of(recording, declared_axis(), groups_of(recording))
    values = {p.name: p.value for p in bench.predictor.parameters}
    runs = {run.name: run for run in bench.experiments(values, bench.parts["select"])}
    fast, half, _ = (runs[f"let go at {what}"] for what in LET_GO)
    speeds = [float(np.abs(run.notes["speed"][:20]).mean()) for run in (fast, half)]
    assert speeds[1] / speeds[0] == pytest.approx(0.5, abs=0.1)  # friction takes some of each
