"""Coupling of clutches: who feels whom is found out, not assumed."""

from simpter_hybrid.effects.cross_coupling import CrossCoupling
from simpter_hybrid.identification.tip.candidates import tip_candidates


def _found(m):
    named = {c.name: c for c in tip_candidates(2, m, (30.0, 10.0), 4.0, 0.8)}
    return named.get("cross-coupling")


def test_every_pair_has_a_gain_of_its_own():
    coupling = _found(3)
    values = {p.name: 0.0 for p in coupling.parameters} | {"cross-coupling.2 from 3.gain": 0.1}
    pairs = {(e.clutch, int(e.neighbour)): e.gain for e in coupling.made(values)}
    assert pairs == {(0, 1): 0, (0, 2): 0, (1, 0): 0, (1, 2): 0.1, (2, 0): 0, (2, 1): 0}
    assert all(isinstance(e, CrossCoupling) for e in coupling.effects())


def test_a_single_clutch_feels_none():
    assert _found(1) is None
