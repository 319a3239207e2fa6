"""Work, stored energy and dissipation agree; a clutch never delivers power."""

import pytest
from sampled_runs import FORCE, START, baseline, locked, oscillator

from simpter_hybrid.measuring.energy import energy_balance


@pytest.mark.parametrize("run", [baseline, locked, oscillator])
def test_the_budget_closes_to_the_tolerance_of_the_solver(run):
    balance = energy_balance(run())
    assert balance.relative < 1e-8
    # Zero but for the rounding of slip velocity just before a stop: 1e-14 rad/s times 100 N m.
    assert balance.max_clutch_power <= 1e-12


def test_friction_takes_all_the_energy_of_an_oscillator():
    run = oscillator()
    block = run.scenario.device
    balance = energy_balance(run)
    rest = run.end[0]
    assert balance.stored_start == 0.5 * block.stiffness * START**2
    lost = 0.5 * block.stiffness * (START**2 - rest**2)
    # Solver tolerance 1e-10 on each of some hundred steps.
    assert balance.dissipated[0] == pytest.approx(lost, rel=1e-8)
    travelled = lost / FORCE
    assert travelled > START
