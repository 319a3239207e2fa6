"""Breakaways are looked for where a rotor rests: where it never does, nobody would miss them."""

from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.recorded_run import RecordedRun
from simpter_hybrid.identification.rotor.never_rests import never_rests
from simpter_hybrid.identification.rotor.signals import RotorSignals

TIME, NOISE = 0.002 * np.arange(1, 1001), 0.01


def run_of(zero=0.0, rests=500, torque=1.0, command=4.0, gains=0.002):
    """A rotor that leaves after so many rows; a servo holds it where no torque is told."""
    noise = NOISE * np.random.default_rng(2).standard_normal(TIME.size)
    speed = np.maximum(np.arange(TIME.size) - rests, 0) * gains
    every = np.ones(TIME.size)
    channels = {"speed": speed + zero + noise, "command": command * every,
                "reference_torque": torque * every}  # fmt: skip
    return RecordedRun("run", "", "", (0, TIME.size), TIME, channels)


def told(*runs):
    recording = SimpleNamespace(runs=runs)
    return list(never_rests(recording, RotorSignals(), {"speed": NOISE}))


def test_a_zero_of_the_speed_hides_all_rests():
    (said,) = told(run_of(0.08), run_of(0.08))
    assert "no breakaway is compared" in said.what
    assert said.value == "2 runs"


def test_one_run_that_rests_is_enough():
    assert told(run_of(0.08), run_of()) == []


def test_a_speed_that_crosses_zero_does_not_rest():
    crossing = run_of(-2.0, rests=0, gains=0.01)
    assert len(told(crossing)) == 1


@pytest.mark.parametrize("other", [{"torque": np.nan}, {"command": 0.0}], ids=["servo", "off"])
def test_runs_in_which_none_are_looked_for_are_not_asked(other):
    assert told(run_of(0.08, **other)) == []
