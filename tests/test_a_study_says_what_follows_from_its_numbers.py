"""Sentences of studies where their numbers say otherwise than they did once."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.reproduce.standard import CONTROLLERS
from simpter_hybrid.rigs.inputs import nominal
from simpter_hybrid.studies import other_brakes, standard_input, torque_sensing


@pytest.mark.parametrize(
    ("gains", "words"),
    [
        ((0.04, 0.08, 0.16), "a faster rate bears more gain"),
        ((0.08, 0.08, 0.08), "a faster rate does not always bear more"),
        ((0.04, 0.16, 0.16), "a faster rate does not always bear more"),
    ],
)
def test_equal_gains_are_no_rise(gains, words):
    one = SimpleNamespace(error=np.ones(2), jerk=np.ones(2))
    rates = torque_sensing.RATES
    found = {(rate, gain): one for rate in rates for gain in torque_sensing.GAINS}
    best = {rate: [gain] * 2 for rate, gain in zip(rates, gains, strict=True)}
    said = torque_sensing.sentences(found, best, {rate: np.ones(1) for rate in rates})
    assert words in said[1]


def test_rankings_that_agree_are_told_so():
    forces = (standard_input.THESIS, standard_input.STEPS)
    found = {
        (force, name): SimpleNamespace(error=np.full(3, float(k)))
        for force in forces
        for k, name in enumerate(CONTROLLERS)
    }
    assert standard_input.rankings(found, forces[1]).endswith("with the thesis's alike.")
    found[forces[0], "baseline"].error[:] = 9.0
    assert standard_input.rankings(found, forces[1]).endswith("a ranking belongs to its force.")


@pytest.mark.parametrize(("which", "drag"), [(n, b[-1]) for n, b in other_brakes.BRAKES.items()])
def test_brakes_have_the_torque_of_39_and_about_their_drag(which, drag):
    law = other_brakes.braked("impedance", 0.16, nominal(), which).clutches[0].torque
    numbers = [getattr(law, name) for name in ("scale", "slope", "offset", "a", "b", "c")]
    found = law.slip_torque(0.0, 10.0, *numbers) / other_brakes.FULL
    assert math.isclose(found, 1.0 + drag, abs_tol=1e-3)
