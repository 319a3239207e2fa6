"""A force a thousand times too large: simulated for minutes, and explained by what is not there."""

from types import SimpleNamespace

import numpy as np
import pytest
from axis_recordings import MAP, declared_axis, recorded_axis

from simpter_hybrid.identification.benches import bench_of
from simpter_hybrid.identification.deviations import scaled
from simpter_hybrid.identification.doubted_channels import Doubt
from simpter_hybrid.identification.doubted_first import _refuse_certain, doubted_first
from simpter_hybrid.identification.map_changes import Times
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.problems import InvalidInput

UNIT = 'unit = "lbf*in"'


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    made = tmp_path_factory.mktemp("axis")
    recorded_axis(made, [])
    return made


def asked(folder, described):
    (folder / "map.toml").write_text(described, encoding="utf-8")
    recording = load_recording(folder / "data.csv", folder / "map.toml")
    bench = bench_of(recording, declared_axis(), groups_of(recording))
    values = {p.name: p.value for p in bench.predictor.parameters}
    parts = scaled(bench.parts, bench.predictor, values)
    return doubted_first(bench, recording, values, values, parts)


@pytest.mark.parametrize("times", [0.001, 1000.0])
def test_that_is_refused(folder, times):
    said = rf"torque\.unit: with this channel times {1 / times:g}.* an inertia, .* {times:g} times"
    with pytest.raises(InvalidInput, match=said):
        asked(folder, MAP.replace(UNIT, f"{UNIT}\ntimes = {times}"))


@pytest.mark.parametrize("factor", [360.0 / 60.0, 60.0 / (2.0 * np.pi)])
def test_so_is_a_smaller_factor_with_which_the_declared_model_leaves_noise(factor):
    doubt = Doubt(Times(("speed",), factor), 0.01)
    channel = SimpleNamespace(sign=1, unit="rad/s")
    recording = SimpleNamespace(map=SimpleNamespace(source="map.toml"), channels={"speed": channel})
    with pytest.raises(InvalidInput, match=r"speed.unit: .* errs 100 times less.* or an inertia"):
        _refuse_certain([doubt], 0.02, recording)
    _refuse_certain([doubt], 0.005, recording)  # what is left may be an effect's


def test_so_is_a_sign_with_what_does_the_same(folder):
    with pytest.raises(InvalidInput) as caught:
        asked(folder, MAP.replace("sign = 1", "sign = -1"))
    said = str(caught.value)
    assert ".sign: with this channel turned round the model errs" in said
    assert "torque" in said
    assert "position" in said


def test_a_right_map_is_not_asked_about(folder):
    assert asked(folder, MAP) == ()
