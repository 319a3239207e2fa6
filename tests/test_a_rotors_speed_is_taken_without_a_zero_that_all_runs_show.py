"""A tachometer with another zero shows a speed at rest, where breakaways begin."""

from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.map_file import RecordingMap
from simpter_hybrid.identification.recordings.recorded_run import RecordedRun
from simpter_hybrid.identification.recordings.recording import Recording
from simpter_hybrid.identification.recordings.speed_zero import speed_zeros, zero_remarks
from simpter_hybrid.identification.reporting.apart import apart_sentence
from simpter_hybrid.identification.rotor.conditioning import observed_slips
from simpter_hybrid.identification.rotor.rows import as_rotor

TIME, NOISE, ZERO = 0.002 * np.arange(1, 1501), 0.01, 0.05
CHANNELS = {
    "clutch_torque": ChannelMap("clutch_torque", "c", "N*m", "measured"),
    "reference_torque": ChannelMap("reference_torque", "r", "N*m", "input", held="before"),
    "reference_speed": ChannelMap("reference_speed", "s", "rad/s", "input", held="before"),
    "position": ChannelMap("position", "q", "rad", "measured"),
    "speed": ChannelMap("speed", "w", "rad/s", "measured"),
}


def recorded(zero):
    """Four runs that rest, leave after a second, each faster than the last, and rest again."""
    noise, runs = np.random.default_rng(5), []
    for k in range(4):
        speed = (0.5 + 0.3 * k) * np.clip(np.minimum(TIME - 1.0, 2.5 - TIME) / 0.2, 0.0, 1.0)
        angle = np.cumsum(speed) * 0.002
        seen = speed + zero + NOISE * noise.standard_normal(TIME.size)
        nothing = np.zeros(TIME.size)
        channels = {"clutch_torque": nothing, "reference_torque": nothing,
                    "reference_speed": nothing, "position": angle, "speed": seen}  # fmt: skip
        runs.append(RecordedRun(f"run {k}", "", "", (0, TIME.size), TIME, channels))
    described = RecordingMap("map.toml", CHANNELS["speed"], CHANNELS)
    told = zero_remarks(list(speed_zeros([(r.time, r.channels) for r in runs], CHANNELS)), CHANNELS)
    return Recording("data.csv", described, tuple(runs), tuple(told))


def test_as_recorded_it_never_rests():
    assert not any(observed_slips(r.channels["speed"], NOISE)[1] for r in recorded(ZERO).runs)


@pytest.mark.parametrize("zero", [ZERO, -ZERO])
def test_so_it_rests_and_breaks_away(zero):
    recording = recorded(zero)
    for right in as_rotor(recording).runs:
        ((left, _),), (stop,) = observed_slips(right.channels["speed"], NOISE)
        assert left == pytest.approx(500, abs=10)
        assert stop == pytest.approx(1250, abs=10)


def test_its_map_is_that_with_the_offset():
    channel = as_rotor(recorded(ZERO)).channels["speed"]
    assert channel.to_si(ZERO) == pytest.approx(0.0, abs=1e-3)


def test_it_is_asked_about_before_the_verdict():
    said = apart_sentence(recorded(ZERO), ())
    assert "by the same in every run (0.0503 rad/s): is the zero of its sensor off?" in said
    assert "What follows takes that off" in said
    of_axis = SimpleNamespace(runs=(), findings=recorded(ZERO).findings, channels={})
    assert apart_sentence(of_axis, ()) == ""


def test_a_right_one_stays_as_it_is():
    recording = recorded(0.0)
    assert as_rotor(recording) is recording
    assert apart_sentence(recording, ()) == ""
