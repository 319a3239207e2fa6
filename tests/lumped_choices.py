"""What Case 7 lets go when a load becomes too much, beside what must go; single instants."""

from __future__ import annotations

import numpy as np
from enumerated_modes import follow_the_rule
from karnopp_states import C, random_mass, work

from simpter_hybrid.karnopp.general import torques
from simpter_hybrid.karnopp.lumped import hold_or_slip

MAP = np.reshape(C, (4, 2))
#: By how much the load grows past what can be held, in units of that; None: from nothing.
GROWTH = (1e-6, 1e-3, 0.05, 0.2, None)


class Choice:
    """The two options that Case 7 reads."""

    def __init__(self, rules):
        self.both = int(rules.signs == "both")
        self.relative = int(rules.closest == "relative")


def strength(f, breakaway, stuck):
    """By which factor ``f`` (2,) may be multiplied until no torques of the set hold it.

    Torques fill a zonotope; its sides are the directions that one clutch leaves free.
    """
    found = np.inf
    for k in stuck:
        y = np.array([-MAP[k][1], MAP[k][0]])
        reach = sum(abs(MAP[i] @ y) * breakaway[i] for i in stuck)
        found = min(found, reach / max(abs(y @ f), 1e-300))
    return found


def must_go(M, f, breakaway, stuck):
    """Clutches that slip: the least motion, by enumeration. Slip torque equals breakaway."""
    S, inverse = MAP[list(stuck)], np.linalg.inv(np.reshape(M, (2, 2)))
    A, d, b = S @ inverse @ S.T, S @ inverse @ np.array(f), np.array(breakaway)[list(stuck)]
    small = 1e-10 * (np.abs(A) @ b + np.abs(d)).max()
    found = follow_the_rule(A, d, -b, b, -b, b, [True] * len(stuck), small)
    return tuple(i for i, way in zip(stuck, found, strict=True) if way != 0)


def let_go(M, before, after, breakaway, stuck, rules):
    """Clutches that Karnopp's model lets go when the load steps; None if it did not hold before."""
    last = [0.0] * 4
    for f in (before, after):
        w = work(M, f, breakaway, stuck, last)
        if rules.cases == "table":
            hold_or_slip(4, Choice(rules), w)
        else:
            torques(2, 4, w)
        if f is before and sum(w.over) > 0:
            return None
        last = list(w.now)
    return tuple(i for i in stuck if w.over[i] == 1)


def share_wrong(rules, stuck, growth, draws, seed=0):
    """(wrong, right, not even held before) in ``draws`` random masses, strengths and loads."""
    rng = np.random.default_rng([seed, *stuck])
    count = [0, 0, 0]
    for _ in range(draws):
        M, breakaway, f = random_mass(rng), rng.uniform(0.2, 2.0, 4), rng.normal(size=2)
        f *= strength(f, breakaway, stuck)
        # Not less than half: the enumeration tells motion from rest to about ten digits.
        step = (0.2 if growth is None else growth) * rng.uniform(0.5, 1.0)
        before = np.zeros(2) if growth is None else (1.0 - growth * (1.0 - rng.random())) * f
        released = let_go(M, before, (1.0 + step) * f, breakaway, stuck, rules)
        if released is None:
            count[2] += 1
        else:
            count[released == must_go(M, (1.0 + step) * f, breakaway, stuck)] += 1
    return count
