"""Friction takes work from a tester: a force that runs against the motion has the wrong sign."""

from dataclasses import replace

import numpy as np
import pytest
from axis_recordings import declared_axis

from simpter_hybrid.effects.bias_force import BiasForce
from simpter_hybrid.identification.axis.tester_work import check_work
from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.maps import MAPS
from simpter_hybrid.identification.recordings.map_file import read_map
from simpter_hybrid.identification.recordings.recording import Recording
from simpter_hybrid.problems import InvalidInput

TIME, INERTIA = 0.01 * np.arange(1000), 2.0
RECORDING = Recording("data.csv", read_map(MAPS / "pneu_seal.toml"), ())


def run(sign, speed, spring=0.0):
    """A tester moves a mass that rubs with 3 N, and a spring that nobody declared."""
    position, bent = np.cumsum(speed) * 0.01, np.gradient(speed, TIME)
    force = sign * (3.0 * np.sign(speed) + spring * position + INERTIA * bent)
    seen = {"force": Observation(force, 0.1, np.ones(TIME.size, bool))}
    notes = {"position": position, "speed": speed, "acceleration": sign * bent}
    return {"fit": [Replay("a", "a", TIME, {}, seen, drive_is_exact=False, notes=notes)]}


TO_AND_FRO, FORTH = np.sin(3.0 * TIME), 1.0 + 0.5 * np.sin(3.0 * TIME)


@pytest.mark.parametrize("spring", [0.0, 50.0])
def test_one_that_takes_the_device_along_is_right(spring):
    check_work(run(1.0, TO_AND_FRO, spring), RECORDING, declared_axis(), INERTIA)


def test_one_that_its_motion_drives_is_refused_with_how_much():
    with pytest.raises(InvalidInput, match=r"force\.sign.*negative work.*-100 %"):
        check_work(run(-1.0, TO_AND_FRO), RECORDING, declared_axis(), INERTIA)


def test_in_one_direction_a_weight_may_sink():
    check_work(run(-1.0, FORTH), RECORDING, declared_axis(), INERTIA)


def test_a_model_with_a_weight_is_not_asked():
    heavy = replace(declared_axis(), effects=(BiasForce(5.0),))
    check_work(run(-1.0, TO_AND_FRO), RECORDING, heavy, INERTIA)
