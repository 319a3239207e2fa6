"""Friction goes against the motion, so a tester's force goes with it: else its sign is wrong."""

from dataclasses import replace

import numpy as np
import pytest
from axis_recordings import declared_axis

from simpter_hybrid.effects.bias_force import BiasForce
from simpter_hybrid.identification.axis.tester_sign import check_sign
from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.maps import MAPS
from simpter_hybrid.identification.recordings.map_file import read_map
from simpter_hybrid.identification.recordings.recording import Recording
from simpter_hybrid.problems import InvalidInput

TIME, INERTIA = 0.002 * np.arange(5000), 2.0
RECORDING = Recording("data.csv", read_map(MAPS / "pneu_seal.toml"), ())


def moved(sign, rate, late=0.0, spring=0.0, offset=0.0):
    """A tester moves a mass that rubs with 3 N, and a spring that nobody declared."""

    def course(time):
        wave = np.sin(rate * time), rate * np.cos(rate * time), -(rate**2) * np.sin(rate * time)
        return wave[0] + offset, wave[1], wave[2]

    position, speed, bent = course(TIME)
    force = sign * (3.0 * np.sign(speed) + spring * position + INERTIA * bent)
    seen = {"force": Observation(force, 0.1, np.ones(TIME.size, bool))}
    notes = dict(zip(("position", "speed", "acceleration"), course(TIME - late), strict=True))
    return {"fit": [Replay("a", "a", TIME, {}, seen, drive_is_exact=False, notes=notes)]}


@pytest.mark.parametrize(
    "right",
    [{}, {"spring": 50.0, "offset": 2.0}, {"rate": 10.0, "late": 0.005},
     {"rate": 10.0, "late": -0.02}],
    ids=["plain", "a bent spring", "shown late", "shown early"],
)  # fmt: skip
def test_one_that_goes_with_it_is_right(right):
    check_sign(moved(1.0, **{"rate": 2.0, **right}), RECORDING, declared_axis())


def test_one_that_goes_against_it_is_refused():
    with pytest.raises(InvalidInput, match=r"force\.sign.*against the motion.*got -0\.\d\d times"):
        check_sign(moved(-1.0, 1.0), RECORDING, declared_axis())


def test_at_one_speed_to_and_fro_drag_and_friction_are_one():
    speed = np.sign(np.sin(3.0 * TIME) + 1e-9)
    position = np.cumsum(speed) * 0.002
    seen = {"force": Observation(-3.0 * speed, 0.1, np.ones(TIME.size, bool))}
    notes = {"position": position, "speed": speed, "acceleration": 0.0 * TIME}
    runs = {"fit": [Replay("a", "a", TIME, {}, seen, drive_is_exact=False, notes=notes)]}
    with pytest.raises(InvalidInput, match=r"got -1\.00 times"):
        check_sign(runs, RECORDING, declared_axis())


def test_in_one_direction_a_weight_may_sink():
    parts = moved(-1.0, 2.0)
    (run,) = parts["fit"]
    forth = {**run.notes, "speed": np.abs(run.notes["speed"])}
    check_sign({"fit": [replace(run, notes=forth)]}, RECORDING, declared_axis())


def test_a_model_with_a_weight_is_not_asked():
    heavy = replace(declared_axis(), effects=(BiasForce(5.0),))
    check_sign(moved(-1.0, 1.0), RECORDING, heavy)
