"""The work that a load takes back is counted within the solver's steps, not between outputs."""

import math

import pytest
from devices_for_tests import Block, Ramp, always_on

from simpter_hybrid.engine import simulate
from simpter_hybrid.measuring.metrics import measures
from simpter_hybrid.scenario import Scenario


def test_a_constant_force_on_an_oscillator_takes_back_what_it_gave():
    # x = F/k (1 - cos(omega t)): in every half period the force gives 2 F^2/k or takes it back.
    force, stiffness, periods = 3.0, 40.0, 2
    run = simulate(Scenario(
        "swing", Block(stiffness=stiffness), (always_on(1e-12, 1e-12),), (0.0,), (0.0,),
        periods * 2.0 * math.pi / math.sqrt(stiffness), loads=(Ramp(0.0, ((0.0, force),)),),
        command=(1.0,), excitation=(1.0,),
    ))  # fmt: skip
    found = [measures(run, step).energy_given_back for step in (1e-3, 0.1, 0.7)]
    assert found[0] == found[1] == found[2]
    # A turn between two of the eight parts of a step is missed by a share of some 1e-4 at most.
    assert found[0] == pytest.approx(periods * 2.0 * force**2 / stiffness, rel=1e-3)
