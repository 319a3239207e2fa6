"""Nothing cuts what a controller of one's own commands: how long it was out of range is said."""

from dataclasses import dataclass

from devices_for_tests import Coulomb

from simpter_hybrid import compiled
from simpter_hybrid.clutch import Clutch
from simpter_hybrid.controller import Controller
from simpter_hybrid.devices.testbed import Testbed
from simpter_hybrid.measuring.command_range import beyond_range
from simpter_hybrid.scenario import Scenario


@dataclass(frozen=True)
class Asks(Controller):
    most: float

    @staticmethod
    def step(k, held, most):
        held[0] = most if k % 2 == 1 else -1e-12


def told(most):
    run = Scenario("asks", Testbed(1.0), (Clutch(Coulomb(1.0, 1.0)),), (0.0,), (9.0,), 0.4)
    return beyond_range(compiled.simulate(run.replace(controllers=((Asks(most), 1),), period=0.1)))


def test_for_how_long_and_how_far():
    (said,) = told(50.0)
    assert "clutch 1 was commanded beyond its range (0 V to 10 V) for 0.2 of 0.4 s" in said
    assert "(from 50 V to 50 V)" in said


def test_full_scale_is_in_range():
    assert told(10.0) == []
