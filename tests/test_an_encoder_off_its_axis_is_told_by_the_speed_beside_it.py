"""A position with a wave once a turn, a speed without; and all that could be taken for it."""

from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.identification.doubted_channels import Doubt
from simpter_hybrid.identification.map_changes import OnAxis, Times
from simpter_hybrid.identification.recordings.off_axis import (
    OffAxis,
    off_axis,
    off_axis_remarks,
    put_on_axis,
)
from simpter_hybrid.identification.recordings.recorded_run import RecordedRun
from simpter_hybrid.identification.reporting.doubted_sentence import doubted_sentence

TIME = 0.004 * np.arange(2500)


def channel(unit):
    return SimpleNamespace(
        unit=unit, role="measured", written_size=lambda value: f"{value:.3g} rad"
    )


CHANNELS = {"position": channel("rad"), "speed": channel("rad/s")}


def runs(shown=lambda q: q, offset=0.0, gain=1.0, noise=1e-4, count=4):
    random, made = np.random.default_rng(7), []
    for k in range(count):
        rate = 0.8 + 0.2 * k
        angle, speed = 1.1 * np.sin(rate * TIME) + 0.1 * k, 1.1 * rate * np.cos(rate * TIME)
        seen = shown(angle) + noise * random.standard_normal(TIME.size)
        told = gain * speed + offset + 0.002 * random.standard_normal(TIME.size)
        both = {"position": seen, "speed": told}
        made.append(RecordedRun(f"run {k}", "", "", (0, TIME.size), TIME, both))
    return made


def wave(angle):
    return angle + 0.02 * np.sin(angle + 0.5)


@pytest.mark.parametrize("offset", [0.0, 0.02])
def test_its_size_and_phase_are_told_whatever_the_zero_of_the_speed(offset):
    (found,) = off_axis(runs(wave, offset), CHANNELS)
    # Noise of the speed sums up to 0.4 mrad in a run.
    assert found.cosine == pytest.approx(0.02 * np.sin(0.5), abs=1e-3)
    assert found.sine == pytest.approx(0.02 * np.cos(0.5), abs=1e-3)
    (remark,) = off_axis_remarks(runs(wave, offset), CHANNELS)
    assert float(remark.value.split()[0]) == pytest.approx(0.02, abs=1e-3)


def test_of_runs_that_go_round_at_one_speed_each_as_well():
    random, made = np.random.default_rng(8), []
    for k in range(4):
        rate = 2 * np.pi * (1.0 + 0.3 * k)
        seen = wave(rate * TIME) + 1e-4 * random.standard_normal(TIME.size)
        told = rate + 0.002 * random.standard_normal(TIME.size)
        both = {"position": seen, "speed": told}
        made.append(RecordedRun(f"run {k}", "", "", (0, TIME.size), TIME, both))
    (found,) = off_axis(made, CHANNELS)
    assert found.size == pytest.approx(0.02, abs=1e-3)


def test_without_the_wave_position_and_speed_agree():
    made = runs(wave)
    (found,) = off_axis(made, CHANNELS)
    assert list(off_axis(put_on_axis(made, found), CHANNELS)) == []


@pytest.mark.parametrize(
    "made",
    [
        runs(),
        runs(offset=0.02),
        runs(gain=1.03),
        runs(lambda q: q + 0.02 * q**2),
        runs(lambda q: q + 0.01 * q + 0.02 * q**2),
        runs(wave, count=1),
    ],
    ids=["right", "a zero of the speed", "a gain", "a bend", "both", "a single run"],
)
def test_nothing_else_is(made):
    assert list(off_axis(made, CHANNELS)) == []


def test_a_slide_has_no_axis():
    assert list(off_axis(runs(wave), CHANNELS | {"position": channel("m")})) == []


OFF = OnAxis(("position",), OffAxis("position", "speed", 0.02, 0.0))


def test_the_question_before_a_verdict_names_it():
    said = doubted_sentence([Doubt(OFF, 0.04)])
    assert said.startswith("Is an encoder off its axis? With ")
    assert "position less a wave of 0.02 rad once a turn only 4 %" in said
    both = doubted_sentence([Doubt(Times(("speed",), 10.0), 0.3), Doubt(OFF, 0.4)])
    assert both.startswith("Is a unit in the map wrong, or is an encoder off its axis?")
