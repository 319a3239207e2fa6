"""Speeds against the positions beside them, sensors against the model."""

from types import SimpleNamespace

import numpy as np
import pytest
from axis_recordings import MAP, SPEED, declared_axis, recorded_axis

from simpter_hybrid.identification.benches import bench_of
from simpter_hybrid.identification.deviations import scaled
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.doubted_channels import (
    NOTHING,
    doubted_channels,
    least_wrong,
)
from simpter_hybrid.identification.doubted_readings import _same
from simpter_hybrid.identification.fitting.replay import Replay
from simpter_hybrid.identification.fitting.residual import rms, weighted_residuals
from simpter_hybrid.identification.map_changes import Times
from simpter_hybrid.identification.recordings.agreement import disagreements, gains_apart
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.identification.reporting.doubted_sentence import doubted_sentence

TIME = np.linspace(0.0, 4.0, 801)
ANGLE = np.sin(2.0 * TIME)
RATE = 2.0 * np.cos(2.0 * TIME)


def _said(angle, rate, role="measured"):
    channels = {"position_1": angle, "speed_1": rate}
    described = {name: SimpleNamespace(role=role) for name in channels}
    return list(disagreements([(TIME, channels)], described))


@pytest.mark.parametrize(
    ("factor", "word"), [(-1.0, "sign"), (-0.1, "sign"), (0.105, "unit"), (9.55, "unit")]
)
def test_a_speed_is_the_rate_of_its_position(factor, word):
    (found,) = _said(ANGLE, RATE / factor)
    assert word in found.right
    # Integrated by trapezoids of 5 ms: a part of 1e-5.
    assert found.factor == pytest.approx(factor, rel=1e-4)
    assert not _said(ANGLE, RATE / factor, role="constant")


def test_a_sensor_that_is_off_by_less_is_left_to_the_diagnosis():
    noise = np.random.default_rng(3).normal(0.0, 0.02, TIME.size)
    assert not _said(ANGLE, 1.4 * RATE)
    assert not _said(ANGLE + noise, RATE)
    assert not _said(noise, noise[::-1])  # nothing moved: nothing can be said
    assert not _said(np.full(TIME.size, np.nan), RATE)


def _asker(folder, described, part="select", worse=1.0):
    """What tells doubts of a folder's recording, were that map its own; the refit errs `worse`."""
    (folder / "map.toml").write_text(described, encoding="utf-8")
    recording = load_recording(folder / "data.csv", folder / "map.toml")
    bench = bench_of(recording, declared_axis(), groups_of(recording))
    values = {p.name: p.value for p in bench.predictor.parameters}
    runs = scaled(bench.parts, bench.predictor, values)[part]
    error = worse * rms(weighted_residuals(bench.predictor, values, runs))
    return lambda floor=0.0: doubted_channels(
        bench, recording, values, runs, error, floor * error, part
    )


def _asked(folder, described, floor=0.0, **more):
    return _asker(folder, described, **more)(floor)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    made = tmp_path_factory.mktemp("axis")
    recorded_axis(made, [])
    return made


@pytest.mark.parametrize(
    ("old", "new", "channel", "factor"),
    [
        ("sign = 1", "sign = -1", "torque", -1.0),
        ('"lbf*in"', '"N*m"', "torque", 0.1),  # 8.85: the nearest that is asked for
        ('"deg"', '"rad"', "position", np.pi / 180.0),
        ('"deg"', '"rev"', "position", 1.0 / 360.0),
        ('"lbf*in"', '"lbf*in"\ntimes = 4', "torque", 0.25),
        ('"deg"', '"deg"\ntimes = 0.5', "position", 2.0),  # of an encoder's edges every other
        ("[split]", "[split]", "", None),
    ],
)
def test_a_channel_that_fits_times_a_factor_is_doubted(folder, old, new, channel, factor):
    ask = _asker(folder, MAP.replace(old, new))
    found = ask()
    said = {doubt.change.channels: doubt.change.factor for doubt in found}
    assert said.get((channel,)) == (factor and pytest.approx(factor))
    assert bool(said) == bool(factor)
    assert all(doubt.left < 0.5 for doubt in found)
    if found:
        sentence = doubted_sentence(found)
        word = "sign" if factor < 0.0 else "gain" if 0.2 < factor < 5.0 else "unit"
        assert word in sentence
        assert channel in sentence
        told = {np.pi / 180: "degrees, not radians", 1 / 360: "degrees, not turns"}
        assert told.get(factor, "") in sentence
    assert ask(floor=0.5) == ()


def test_the_fitted_runs_can_be_asked_as_well(folder):
    found = _asked(folder, MAP.replace("sign = 1", "sign = -1"), part="fit")
    assert {doubt.change.channels: doubt.change.factor for doubt in found}["torque",] == -1.0


def test_what_is_no_better_than_the_model_as_declared_is_not_asked(folder):
    # A refit to other runs may be ten times worse on these; a factor that does nothing is not.
    assert _asked(folder, MAP, worse=10.0) == ()


@pytest.mark.parametrize(("idle", "doubted"), [(0.6, False), (0.9, True)])
def test_what_an_idle_channel_leaves_counts_though_no_factor_that_leaves_as_much_would(
    folder, monkeypatch, idle, doubted
):
    module = "simpter_hybrid.identification.doubted_channels"
    left = {-1.0: 0.4, NOTHING: idle}  # of an error of 1

    def made(*given):
        (channel, factor), *_ = given[-1].items()
        return left.get(factor, 2.0) if channel == "torque" else 2.0

    monkeypatch.setattr(f"{module}._left_times", made)
    monkeypatch.setattr(f"{module}._hopeless", lambda *given: lambda tried: made(tried) > given[-1])
    for told_by in (module, __name__):
        monkeypatch.setattr(f"{told_by}.rms", lambda residuals: 1.0)
    assert bool(_asked(folder, MAP, floor=1e-3)) is doubted


def test_what_explains_it_by_far_the_best_is_named_alone(tmp_path):
    recorded_axis(tmp_path, [], rate_noise=0.01)
    found = _asked(tmp_path, (MAP + SPEED).replace('"lbf*in"', '"N*m"'))
    assert [doubt.change.channels for doubt in found] == [("torque",)]


def test_a_rig_that_does_not_ask_how_inputs_go_on_is_not_fitted_again():
    time = np.arange(3.0)
    fresh = Replay("run", "run", time, {"command": time}, {}, notes={"start": time[:2]})
    played = Replay("run", "run", time, {"command": time}, {}, notes={**fresh.notes, "kept": time})
    assert _same(played, fresh)
    assert not _same(played, Replay("run", "run", time, {"command": time + 1.0}, {}))


@pytest.mark.parametrize("factor", [0.97, 1.0, 1.03])
def test_a_gain_that_is_a_little_off_in_every_run_is_a_question(factor):
    noise = np.random.default_rng(4).normal(0.0, 0.002, (3, TIME.size))
    runs = [(TIME, {"position_1": ANGLE + n, "speed_1": RATE / factor}) for n in noise]
    described = {name: SimpleNamespace(role="measured") for name in ("position_1", "speed_1")}
    found = gains_apart(runs, described)
    assert len(found) == (factor != 1.0)
    assert all("gain" in f.right for f in found)
    # A tenth of a second alone tells nothing, and twenty of them together do.
    piece = (TIME[:41], {"position_1": ANGLE[:41], "speed_1": RATE[:41]})
    assert len(gains_apart([*runs, piece], described)) == len(found)
    assert not gains_apart([*runs, *[piece] * 20], described)
    other = [*runs, (TIME, {"position_1": ANGLE, "speed_1": RATE})]
    assert not gains_apart(other, described)  # then it is no gain


def test_the_gain_of_a_speed_is_doubted_where_the_model_agrees_with_the_position(tmp_path):
    recorded_axis(tmp_path, [], rate_noise=0.01)
    (tmp_path / "map.toml").write_text(MAP + SPEED + "times = 1.05\n", encoding="utf-8")
    recording = load_recording(tmp_path / "data.csv", tmp_path / "map.toml")
    found = diagnose(recording, declared_axis(), candidates=())
    first = found.doubts[0].change
    assert first.channels == ("speed",)
    # Noise of a hundredth of the speed, in a mean over hundreds of tenths of a second.
    assert first.factor == pytest.approx(1 / 1.05, rel=2e-3)
    assert "gain" in doubted_sentence(found.doubts)


def test_the_factor_on_what_drives_that_comes_nearest(folder):
    described = MAP.replace('"lbf*in"', '"mN*m"')
    (folder / "map.toml").write_text(described, encoding="utf-8")
    recording = load_recording(folder / "data.csv", folder / "map.toml")
    declared = declared_axis()
    bench = bench_of(recording, declared, groups_of(recording))
    values = {p.name: p.value for p in bench.predictor.parameters}
    runs = scaled(bench.parts, bench.predictor, values)["select"]
    error = rms(weighted_residuals(bench.predictor, values, runs))
    found = least_wrong(bench, recording, values, runs, error)
    assert found.change == Times(("torque",), 100.0)  # of 113
