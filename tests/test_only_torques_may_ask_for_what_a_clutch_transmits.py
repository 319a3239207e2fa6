"""Forces are known where torques are found: elsewhere their names are refused as such."""

from dataclasses import dataclass

import pytest
from devices_for_tests import Block, Coulomb

from simpter_hybrid import engine
from simpter_hybrid.assembly.model import WiringError
from simpter_hybrid.clutch import Clutch
from simpter_hybrid.effect import Effect
from simpter_hybrid.effects.bristles import Bristles
from simpter_hybrid.part import parameter
from simpter_hybrid.scenario import Scenario


@dataclass(frozen=True)
class Shifted(Effect):
    share: float = parameter("dimensionless", 0.01)

    @staticmethod
    def effective_excitation(excitation, applied, share):
        return excitation + share * abs(applied)


@dataclass(frozen=True)
class Faster(Effect):
    share: float = parameter("dimensionless", 0.01)

    @staticmethod
    def excitation_rate(rate, conservative, share):
        return rate + share * abs(conservative)


@dataclass(frozen=True)
class Warmer(Effect):
    states = ("heat",)

    @staticmethod
    def heat_rate(net):
        return abs(net)


def run(*effects):
    clutch = Clutch(Coulomb(1.0, 1.0), time_constant=0.1, delay=0.0, threshold=-1.0)
    return engine.simulate(Scenario(
        "x", Block(), (clutch,), (0.0,), (1.0,), 0.2, effects=effects,
        command=(1.0,), excitation=(1.0,),
    ))  # fmt: skip


@pytest.mark.parametrize("effect", [Shifted, Faster, Warmer])
def test_what_is_no_torque_is_refused(effect):
    with pytest.raises(WiringError, match="only torques may ask for"):
        run(effect(clutch=0))


@dataclass(frozen=True)
class Pressed(Effect):
    share: float = parameter("dimensionless", 0.1)

    @staticmethod
    def slip_torque(torque, net, share):
        return torque + share * abs(net)


def test_so_is_presliding_of_a_clutch_whose_friction_asks_for_them():
    with pytest.raises(WiringError, match="do not go together"):
        run(Pressed(clutch=0), Bristles(clutch=0))
