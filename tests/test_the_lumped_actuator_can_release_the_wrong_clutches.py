"""Case 7's previous-step rule at its smallest: three clutches, and a push that comes at once.

Clutches 1, 2, 3 can hold 3, 2 and 1 N m; at t = 0.1 s link A is pushed with 4.5 N m. Clutches 1
and 3 act on link A and can hold 4 N m together, so they let go; clutch 2 holds link B against the
1 N m of clutch 3. Without a push the only special case that fits is "clutch 3 at breakaway", which
asks 1 N m of the others: clutch 2 is then closer to its breakaway torque than clutch 1, and goes.
"""

from dataclasses import dataclass

import pytest
from devices_for_tests import Coulomb, Ramp
from lumped_choices import share_wrong

from simpter_hybrid.applied_load import Load
from simpter_hybrid.clutch import Clutch
from simpter_hybrid.comparison.events import compare_releases
from simpter_hybrid.controller import Controller
from simpter_hybrid.devices.pter import Pter
from simpter_hybrid.engine import simulate as exact
from simpter_hybrid.karnopp import FAIR, THESIS, TUNED, simulate
from simpter_hybrid.scenario import Scenario

SETS = ((0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3), (0, 1, 2, 3))


@dataclass(frozen=True)
class Push(Load):
    """A torque on link A that a controller holds."""

    @staticmethod
    def force(held_push, Q):
        Q[0] += held_push


@dataclass(frozen=True)
class StepUp(Controller):
    """No push, then ``size`` from the second sample on."""

    size: float = 4.5

    holds = ("push",)

    @staticmethod
    def step(k, held, at_push, size):
        held[at_push] = size if k >= 1 else 0.0


def run(sudden: bool) -> Scenario:
    """PTER at rest, clutches 1 to 3 engaged; link A is pushed with 4.5 N m, suddenly or slowly."""
    clutches = tuple(
        Clutch(Coulomb(brk, brk), time_constant=0.0, delay=0.0, threshold=0.01)
        for brk in (3.0, 2.0, 1.0, 1.0)
    )
    on = (1.0, 1.0, 1.0, 0.0)
    start = Scenario(
        "smallest", Pter(1.5, 0.5, -0.1, 0.9, 0.6), clutches, (0.7, 1.6), (0.0, 0.0), 0.2,
        command=on, excitation=on,
    )  # fmt: skip
    if sudden:
        return start.replace(loads=(Push(),), controllers=((StepUp(), 1),), period=0.1)
    return start.replace(loads=(Ramp(0.0, ((0.0, 0.0), (0.2, 4.5))),))


def released(sudden, rules):
    """What the exact engine and Karnopp let go."""
    scenario = run(sudden)
    reference = exact(scenario)
    found = compare_releases(reference, simulate(scenario, 1e-4, rules=rules, max_steps=3000), 5e-3)
    assert len(found) == 1
    return found[0].reference, found[0].first


@pytest.mark.parametrize("rules", [THESIS, FAIR])
def test_a_step_of_the_load_releases_the_wrong_clutches(rules):
    # Two of three are chosen, clutches 2 and 3; clutch 1 then cannot hold what is left.
    assert released(True, rules) == ((1, 3), (1, 2, 3))


@pytest.mark.parametrize("rules", [THESIS, FAIR])
def test_a_slow_load_releases_the_right_ones(rules):
    # Just before the end only one special case holds, and it tells the clutches apart.
    assert released(False, rules) == ((1, 3), (1, 3))


@pytest.mark.parametrize("sudden", [True, False])
def test_without_the_lumped_actuator_the_right_ones_go(sudden):
    assert released(sudden, TUNED) == ((1, 3), (1, 3))


def test_the_wrong_release_heals_within_a_time_that_falls_with_the_band():
    # Clutch 2 slips until it leaves the band, and is then caught again: the error is of the size
    # of the band times that time, so each decade of the band takes at least one off the error.
    scenario = run(True)
    end = exact(scenario).end[:2]
    errors = [
        abs(simulate(scenario, b, rules=FAIR).end[:2] - end).max() for b in (1e-2, 1e-3, 1e-4)
    ]
    assert errors[0] > 1e-4
    assert errors[1] < 0.12 * errors[0]
    assert errors[2] < 0.12 * errors[1]


@pytest.mark.parametrize("stuck", SETS)
@pytest.mark.parametrize("rules", [THESIS, FAIR])
def test_it_guesses_when_loads_jump_and_knows_when_they_creep(rules, stuck):
    # Against enumeration. A load that has grown by 1e-6 of its size since the last step: within
    # that distance of a corner of what can be held, either answer is right; no draw is so near.
    assert share_wrong(rules, stuck, 1e-6, 20)[0] == 0
    wrong, right, _ = share_wrong(rules, stuck, None, 20)
    assert 0.2 < wrong / (wrong + right) < 0.8


@pytest.mark.parametrize("stuck", SETS)
def test_worst_first_is_right_for_every_load(stuck):
    assert share_wrong(TUNED, stuck, None, 20)[:2] == [0, 20]
