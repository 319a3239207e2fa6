"""A clutch without a lag that is on at the start, and asked for by the first sample, never opens.

Closed form: the block of 1 kg is braked by 1 N from 0.5 m/s on, v = 0.5 - t.
"""

import pytest
from devices_for_tests import Block, Coulomb, RecordedCommands

from simpter_hybrid.clutch import Clutch
from simpter_hybrid.engine import simulate as exact
from simpter_hybrid.karnopp import simulate as karnopp
from simpter_hybrid.regularised import simulate as smooth
from simpter_hybrid.scenario import Scenario


@pytest.mark.parametrize("simulate", [exact, karnopp, smooth])
def test_its_delay_does_not_begin_anew(simulate):
    clutch = Clutch(Coulomb(1.0, 1.0), time_constant=0.0, delay=0.02, threshold=0.0)
    scenario = Scenario(
        "prompt", Block(1.0), (clutch,), (0.0,), (0.5,), 0.2, excitation=(1.0,),
        controllers=((RecordedCommands(1.0), 1),), period=0.1, rec=(1.0,) * 4,
    )  # fmt: skip
    assert simulate(scenario).end[1] == pytest.approx(0.3, abs=1e-6)
