"""Case 7: "any feasible combination of clutch torques" against linear programming."""

import itertools

import numpy as np
import pytest
from karnopp_states import C, random_mass, work
from scipy.optimize import linprog

from simpter_hybrid.karnopp import FAIR, Rules
from simpter_hybrid.karnopp.lumped import hold_or_slip
from simpter_hybrid.karnopp.settings import Settings

MAP = np.reshape(C, (4, 2))


class Choice:
    """The two options that Case 7 reads."""

    def __init__(self, rules):
        self.both = int(rules.signs == "both")
        self.relative = int(rules.closest == "relative")


def reserve(f, breakaway, stuck):
    """By which factor the load could grow until no torques hold it."""
    S = MAP[list(stuck)]
    k = len(stuck)
    # Largest s with S^T tau = -s f and |tau| <= breakaway.
    equal = np.hstack([S.T, np.reshape(f, (2, 1))])
    bounds = [(-breakaway[i], breakaway[i]) for i in stuck] + [(0.0, None)]
    return -linprog([0.0] * k + [-1.0], A_eq=equal, b_eq=[0.0, 0.0], bounds=bounds).fun


@pytest.mark.parametrize("stuck", [s for k in (3, 4) for s in itertools.combinations(range(4), k)])
def test_with_both_signs_it_decides_exactly(stuck):
    rng = np.random.default_rng(len(stuck) + 10 * sum(stuck))
    held = 0
    for _ in range(60):
        breakaway, f = rng.uniform(0.2, 2.0, 4), 2.5 * rng.normal(size=2)
        w = work(random_mass(rng), f, breakaway, stuck)
        hold_or_slip(4, Choice(FAIR), w)
        factor = reserve(f, breakaway, stuck)
        assert abs(factor - 1.0) > 1e-9  # no draw lies on the border, where either answer is right
        assert (sum(w.over) == 0) == (factor > 1.0)
        if factor > 1.0:
            held += 1
            assert MAP.T @ w.now == pytest.approx((-f).tolist(), abs=1e-12)
    assert 5 < held < 55


def test_as_printed_it_lets_a_load_go_that_can_be_held():
    # Clutches 1, 2, 3 of 1 N m each and tau_inA = 1.5: tau_1 = tau_3 = -0.75, tau_2 = -0.75 holds,
    # but every case of (24)-(29) puts a clutch at +1 and asks another for more than 1.
    f, stuck = (1.5, 0.0), (0, 1, 2)
    for rules, slipping in ((FAIR, False), (Rules(signs="printed"), True)):
        w = work([3.0, 0.0, 0.0, 1.0], f, [1.0] * 4, stuck)
        hold_or_slip(4, Choice(rules), w)
        assert (sum(w.over) > 0) == slipping
    assert reserve(f, [1.0] * 4, stuck) > 1.0


def test_the_special_cases_are_the_printed_ones():
    # (24)-(29) in the order of the thesis; loads for which exactly the named case holds.
    b1, b2, b3 = 1.0, 1.4, 0.7
    for a, b in ((-1.5, 0.3), (0.2, -1.9), (-0.6, -0.1)):
        w = work([3.0, 0.0, 0.0, 1.0], (a, b), [b1, b2, b3, 1.0], (0, 1, 2))
        hold_or_slip(4, Choice(Rules(signs="printed")), w)
        tau13 = -a - b1
        tau12 = -b + tau13
        tau23 = b2 + b
        tau21 = -tau23 - a
        tau31 = -a - b3
        tau32 = -b + b3
        cases = ((b1, tau12, tau13), (tau21, b2, tau23), (tau31, tau32, b3))
        fits = [c for c in cases if all(abs(t) <= x for t, x in zip(c, (b1, b2, b3), strict=True))]
        assert fits
        assert w.now[:3] == pytest.approx(fits[0], abs=1e-15)


def test_the_settings_carry_the_rules():
    assert Settings(rules=FAIR).rules.signs == "both"
    with pytest.raises(ValueError, match="choose one of printed, both"):
        Rules(signs="plus")
