"""A rotor and a clutch that meet what an effect can act on: steps, sticks, reversals, rest."""

import dataclasses

from devices_for_tests import Waves

from simpter_hybrid.clutch import Clutch
from simpter_hybrid.controllers.axis_servo import PositionServo
from simpter_hybrid.controllers.neighbour_profile import NeighbourProfile
from simpter_hybrid.controllers.profile import CommandProfile
from simpter_hybrid.devices.shaft_pair import ShaftPair
from simpter_hybrid.devices.testbed import Testbed
from simpter_hybrid.effect import Effect
from simpter_hybrid.effects.cross_coupling import CrossCoupling
from simpter_hybrid.effects.drive_deadband import DriveDeadband
from simpter_hybrid.effects.drive_gain import DriveGain
from simpter_hybrid.effects.drive_lag import DriveLag
from simpter_hybrid.effects.drive_limit import DriveLimit
from simpter_hybrid.effects.drive_released import DriveReleased
from simpter_hybrid.effects.drive_ripple import DriveRipple
from simpter_hybrid.effects.drive_saturation import DriveSaturation
from simpter_hybrid.effects.other_commands import OtherCommands
from simpter_hybrid.effects.other_excitations import OtherExcitations
from simpter_hybrid.effects.stray_field import StrayField
from simpter_hybrid.effects.winding_heat import WindingHeat
from simpter_hybrid.laws import TestbedTorque
from simpter_hybrid.reading.kinds import shipped
from simpter_hybrid.scenario import Scenario

#: Effects that need more clutches than the rig has, or a motor's servo.
ELSEWHERE = (
    "CrossCoupling", "DriveDeadband", "DriveGain", "DriveLag", "DriveLimit", "DriveRipple",
    "DriveReleased", "DriveSaturation",
    "OtherCommands", "OtherExcitations", "StrayField", "WindingHeat",
)  # fmt: skip
#: Commands of a clutch beside it on the same supply.
NEIGHBOUR = ((0.0, 0.0), (0.15, 0.0), (0.15, 5.0), (0.5, 5.0), (0.5, 2.0))
#: Effects that cannot be switched off: another actuator, friction model, or way to move.
ALWAYS = (
    "Bristles", "ClutchBacklash", "CoilSupply", "Dahl", "LuGre", "MaxwellSlip", "PrescribedMotion",
    "ResetIntegrator",
)  # fmt: skip

#: What makes an effect do nothing whose sizes do not.
NOTHING = {"DriveLimit": {"limit": 1e9}}


def rig(effects=(), **options) -> Scenario:
    """Two sinusoids push a rotor; the command steps up, down, off and on again."""
    points = (
        (0.0, 1.0), (0.1, 1.0), (0.1, 2.0), (0.25, 2.0), (0.25, 0.8), (0.45, 0.8), (0.45, 0.0),
        (0.65, 0.0), (0.65, 1.2),
    )  # fmt: skip
    values = {
        "loads": (Waves(((0.0, 3.0, 25.0, 0.3), (0.0, 1.5, 43.0, 1.0))),),
        "controllers": ((CommandProfile(points), 1), (NeighbourProfile(NEIGHBOUR), 1)),
        "t_end": 0.8,
    } | options
    return Scenario(
        "effects", Testbed(0.05), (Clutch(TestbedTorque(), time_constant=0.03),), (0.2,), (1.0,),
        effects=tuple(effects), period=0.05, command=(1.0,), excitation=(1.0,), **values,
    )  # fmt: skip


def attached(cls: type[Effect], size: float | None = None) -> Effect:
    """An effect on the rig, with all its sizes typical (None) or set to ``size``."""
    functions = cls().functions()
    on_coordinate = "force" in functions or "inertia" in functions
    place = {"coordinate": 0} if on_coordinate else {"clutch": 0}
    values = {
        f.name: f.metadata.get("typical") if size is None else size
        for f in dataclasses.fields(cls)
        if f.name in cls.sizes
    }
    return cls(**place, **values)


def all_effects() -> list[type[Effect]]:
    """The shipped effects that need nothing but the rig."""
    return [cls for cls in shipped("effect").values() if cls.__name__ not in ELSEWHERE]


def pair(effects=()) -> Scenario:
    """Two shafts with a clutch between them and a brake, whose commands step in turn; a servo."""
    servo = PositionServo(((0.0, 0.0), (0.5, 1.0)), proportional=2.0)
    first = ((0.0, 1.5), (0.2, 1.5), (0.2, 2.5))
    second = ((0.0, 1.0), (0.1, 1.0), (0.1, 2.0), (0.3, 2.0), (0.3, 0.0))
    clutch = Clutch(TestbedTorque(), time_constant=0.03)
    return Scenario(
        "pair", ShaftPair(0.05, 0.04), (clutch, clutch), (0.0, 0.0), (3.0, 1.0), 0.5,
        loads=(Waves(((0.0, 4.0, 25.0, 0.3), (1.0, 2.0, 43.0, 1.0))),), effects=tuple(effects),
        controllers=((CommandProfile(first), 1), (CommandProfile(second, 1.0), 1), (servo, 1)),
        period=0.05, command=(1.5, 1.0), excitation=(1.5, 1.0),
    )  # fmt: skip


#: Effects on ``pair``.
BETWEEN = {
    "CrossCoupling": CrossCoupling(clutch=0, gain=-0.05, neighbour=1.0),
    "DriveDeadband": DriveDeadband(coordinate=0, width=0.3, constant=1.5),
    "DriveGain": DriveGain(coordinate=0, gain=0.1, constant=1.5),
    "DriveLag": DriveLag(coordinate=0, lag=0.02, constant=1.5),
    "WindingHeat": WindingHeat(coordinate=0, rise=0.5, energy=2.0, constant=1.5, back=0.2),
    "DriveLimit": DriveLimit(coordinate=0, limit=0.5, constant=1.5, back=0.1),
    "DriveReleased": DriveReleased(coordinate=0, share=1.0, below=0.3, constant=1.5, back=0.1),
    "DriveRipple": DriveRipple(coordinate=0, cosine=0.2, number=3.0, constant=1.5),
    "DriveSaturation": DriveSaturation(coordinate=0, fall=0.3, most=0.6, constant=1.5),
    "OtherCommands": OtherCommands(clutch=0, gain=-0.05),
    "OtherExcitations": OtherExcitations(clutch=0, gain=-0.05),
    "StrayField": StrayField(clutch=0, gain=0.1, neighbour=1.0),
}
