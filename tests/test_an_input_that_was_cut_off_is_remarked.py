"""A torque that stays at one value at every peak, beside inputs that may do so."""

import numpy as np
import pytest
from axis_recordings import MAP

from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.identification.reporting.cautions import cut_off_sentence

TIME = np.arange(0.0, 4.0, 0.004)
NOISE = 0.003 * np.random.default_rng(6).normal(size=TIME.size)
WAVE = np.sin(5.0 * TIME) + NOISE
ANGLE = 30.0 * np.sin(TIME)
LIMITS = 'limits = ["-0.7 lbf*in", "0.7 lbf*in"]\n'


def _remarks(folder, torque, described=MAP, angle=ANGLE, other=None):
    rows = ["take,ms,angle,torque"]
    for take in range(3):
        course = zip(1e3 * TIME, angle if take < 2 or other is None else other, torque, strict=True)
        rows += [f"{take},{t:.1f},{a:.4f},{u:.4f}" for t, a, u in course]
    (folder / "data.csv").write_text("\n".join(rows), encoding="utf-8")
    (folder / "map.toml").write_text(described, encoding="utf-8")
    return load_recording(folder / "data.csv", folder / "map.toml").findings


@pytest.mark.parametrize(
    ("torque", "sides"),
    [
        (np.clip(WAVE, -0.7, 0.7), ["largest", "smallest"]),
        (np.minimum(WAVE, 0.7), ["largest"]),
    ],
)
def test_a_torque_that_was_cut_off(tmp_path, torque, sides):
    found = _remarks(tmp_path, torque)
    assert [f.what.split()[4] for f in found] == sides
    assert found[0].value == "0.7 lbf*in"
    assert not any(f.fatal for f in found)
    assert cut_off_sentence(found).startswith("Is a sensor cut off (torque)?")


@pytest.mark.parametrize(
    "torque",
    [
        WAVE,
        np.round(np.sin(5.0 * TIME), 1),  # a coarse step: the tops are flat
        0.7 * np.sign(WAVE),  # set in steps
        np.where(np.abs(TIME - 2.0) < 0.1, 1.5, WAVE),  # once
        np.maximum(WAVE, 0.0),  # pushes one way, and rests
    ],
)
def test_an_input_that_may_stay_there(tmp_path, torque):
    assert not _remarks(tmp_path, torque)


def test_a_limit_that_the_map_states_is_known_and_only_counted(tmp_path):
    found = _remarks(tmp_path, np.clip(WAVE, -0.7, 0.7), MAP + LIMITS)
    assert {f.what.split()[1] for f in found} == {"saturated"}


def test_a_duty_may_be_full(tmp_path):
    described = MAP.replace('"lbf*in"', '"1"').replace("[channels.torque]", "[channels.duty]")
    assert not _remarks(tmp_path, np.clip(2.0 * WAVE, -1.0, 1.0), described)


def test_a_force_of_a_sensor_is_asked_though_rows_hold(tmp_path):
    described = MAP.rstrip() + '\nheld = "after"\n'
    assert "[channels.torque]" in described.split("[channels.position]")[1]
    assert len(_remarks(tmp_path, np.clip(WAVE, -0.7, 0.7), described)) == 2


@pytest.mark.parametrize(("reach", "sides"), [(20.0, ["largest", "smallest"]), (60.0, [])])
def test_a_position_that_may_rest_and_comes_to_the_end_of_its_sensor(tmp_path, reach, sides):
    angle = np.clip(30.0 * np.sin(5.0 * TIME) + NOISE, -reach, reach)
    found = _remarks(tmp_path, WAVE, angle=angle)
    assert [f.what.split()[:5:4] for f in found] == [["position", side] for side in sides]


def test_a_position_that_flickers_where_it_rests_at_its_extreme_stays_there_once(tmp_path):
    rests = np.minimum(30.0 * np.sin(TIME / 1.5), 25.0)
    held = np.flatnonzero(rests == 25.0)
    for part in (0.2, 0.4, 0.6, 0.8):
        rests[held[int(part * held.size)]] -= 0.1  # one count
    # The course is run twice: two stays of five pieces each.
    assert not _remarks(tmp_path, WAVE, angle=np.round(rests, 1), other=np.round(ANGLE / 2, 1))
