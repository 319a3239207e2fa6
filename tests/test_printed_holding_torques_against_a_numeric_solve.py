"""Appendix A, copied a second time and compared with numbers: misprints fail, the rest holds."""

import numpy as np
import pytest

from derivations.audit import report
from derivations.audit.verdict import MISPRINTED, assess

CLUTCH_MAP = np.array([[1, 0], [0, 1], [1, -1], [1, 1]], dtype=float)


@pytest.fixture(scope="module")
def verdicts():
    return {e.number: assess(e).verdict for e in report.all_entries() if e.number.isdigit()}


def eq_23(m, v, a, b, t):
    r = m[0, 1] / m[1, 1]
    return {1: r * t[2] - (r + 1) * t[3] + (r - 1) * t[4] + r * b - a + v[0]}


def eq_58(m, v, a, b, t):
    r = m[1, 0] / m[0, 0]
    return {2: r * t[1] - (r + 1) * t[3] + (r - 1) * t[4] + r * a - b + v[1]}


def eq_61(m, v, a, b, t):
    (m11, m12), (m21, m22) = m
    terms = (m21 + m22) * (-t[1] - a + v[0]) + (m11 + m12) * (t[2] + b - v[1])
    return {3: (terms + (m11 + m12 - m21 - m22) * t[4]) / (m11 + m12 + m21 + m22)}


def eq_63(m, v, a, b, t):
    (m11, m12), (m21, m22) = m
    terms = (m22 - m21) * (t[1] + a - v[0]) + (m11 - m12) * (t[2] + b - v[1])
    return {4: (terms + (-m11 + m12 - m21 + m22) * t[3]) / (-m11 + m12 + m21 - m22)}


SINGLE = {"23": (1, eq_23), "58": (2, eq_58), "61": (3, eq_61), "63": (4, eq_63)}
PAIRS = {
    "66": lambda a, b: {1: b, 3: -a - b},
    "67": lambda a, b: {4: -b, 1: -a + b},
    "68": lambda a, b: {3: -a, 2: -a - b},
    "69": lambda a, b: {4: -a, 2: a - b},
    "72": lambda a, b: {1: -a, 2: -b},
    "76": lambda a, b: {4: (-a - b) / 2, 3: (-a + b) / 2},
}


def numeric_single(stuck, m, v, load, t):
    """Holding torque of one stuck clutch while the others slip with torques t."""
    row = CLUTCH_MAP[stuck - 1]
    others = sum(CLUTCH_MAP[i - 1] * t[i] for i in t if i != stuck)
    block = np.block([[m, -row[:, None]], [row[None, :], np.zeros((1, 1))]])
    return np.linalg.solve(block, np.append(load + others - v, 0.0))[2]


def states(seed):
    rng = np.random.default_rng(seed)
    for _ in range(50):
        low = rng.uniform(-1, 1, (2, 2))
        torques = dict(enumerate(rng.uniform(-5, 5, 4), start=1))
        yield low @ low.T + np.eye(2), rng.uniform(-2, 2, 2), rng.uniform(-9, 9, 2), torques


def agrees_single(number):
    stuck, formula = SINGLE[number]
    for m, v, load, t in states(int(number)):
        if stuck in (1, 2):
            v = v * np.eye(2)[stuck - 1]  # the stuck link is at rest: the other V is zero
        printed = formula(m, v, *load, t)[stuck]
        # one 3 x 3 solve with a condition number below 100
        if abs(printed - numeric_single(stuck, m, v, load, t)) > 1e-11:
            return False
    return True


def agrees_pair(number):
    for _, _, load, _ in states(int(number)):
        torques = PAIRS[number](*load)
        net = sum(CLUTCH_MAP[i - 1] * value for i, value in torques.items()) + load
        if np.abs(net).max() > 1e-12:  # sums of three numbers below 20
            return False
    return True


@pytest.mark.parametrize("number", SINGLE)
def test_one_stuck_clutch(number, verdicts):
    assert agrees_single(number) == (verdicts[number] != MISPRINTED)


@pytest.mark.parametrize("number", PAIRS)
def test_two_stuck_clutches_at_rest(number, verdicts):
    assert agrees_pair(number) == (verdicts[number] != MISPRINTED)


def test_the_misprints_are_these(verdicts):
    found = {number for number, verdict in verdicts.items() if verdict == MISPRINTED}
    assert found == {"6", "40", "48", "58", "66"}
