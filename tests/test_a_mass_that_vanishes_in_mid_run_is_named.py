"""A mass matrix that becomes singular as the device moves on: said, not called too stiff a part."""

from dataclasses import dataclass

import pytest
from devices_for_tests import Block, Ramp, always_on

from simpter_hybrid import compiled, engine
from simpter_hybrid.running.failures import vanished_mass
from simpter_hybrid.scenario import Scenario


@dataclass(frozen=True)
class Burning(Block):
    """A block whose mass has gone where it has moved 3 m on."""

    @staticmethod
    def mass_matrix(q, p, out):
        out[0] = 3.0 - q[0]

    @staticmethod
    def velocity_terms(q, qd, p, out):
        out[0] = -0.5 * qd[0] * qd[0]


RUN = Scenario(
    "burning", Burning(), (always_on(1.0, 1.0),), (0.0,), (1.0,), 10.0,
    loads=(Ramp(0.0, ((0.0, 20.0), (10.0, 20.0))),), command=(1.0,), excitation=(1.0,),
)  # fmt: skip


@pytest.mark.parametrize("simulate", [engine.simulate, compiled.simulate])
def test_the_run_fails_where_it_has_gone(simulate):
    found = simulate(RUN)
    assert found.status == "failed"
    assert "the mass matrix vanishes at x = 3 (SI)" in found.message


def test_a_light_mass_is_no_vanished_one():
    y, _ = RUN.initial(lambda k: [0.0] * k, lambda k: [0] * k)
    assert vanished_mass(RUN, 1.0, [2.9999, *y[1:]]) is None
