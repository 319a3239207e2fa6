"""Effects on a rotor and on its torque sensor, and where their fits begin."""

from __future__ import annotations

from dataclasses import replace

from ...effects.added_inertia import AddedInertia
from ...effects.bias_force import BiasForce
from ...effects.imbalance import Imbalance
from ...effects.quadratic_drag import QuadraticDrag
from ...effects.ripple_force import RippleForce
from ...effects.viscous_drag import ViscousDrag
from ...laws import LBF_IN
from ..rigs.candidate import candidate, sensor_candidate
from ..rigs.effect_candidate import EffectCandidate
from .contact_candidates import FURTHER_WAVES, MOVING
from .sizes import Sizes

R = {"coordinate": 0}
#: Beginning of the names of errors of the sensor of the motor's torque.
OF_MOTOR = "motor sensor"
#: A moment once a turn, and another several times.
WAVES = ("1.cosine", "1.sine", "2.cosine", "2.sine")


def on_the_rotor(sizes: Sizes) -> tuple[EffectCandidate, ...]:
    """Drags, constant and turning forces, and another inertia."""
    L, J, S = LBF_IN * sizes.torque, LBF_IN * sizes.inertia, sizes.speed
    return (
        candidate("viscous-drag", ViscousDrag(**R),
             (("coefficient", -20 * L / S, 20 * L / S, 0.3 * L / S),),
             ((0.0,),), MOVING),
        candidate("quadratic-drag", QuadraticDrag(**R),
             (("coefficient", -10 * L / S**2, 10 * L / S**2, 0.2 * L / S**2),),
             ((0.0,),), MOVING),
        candidate("viscous-quadratic-drag", QuadraticDrag(**R),
             (("1.coefficient", -10 * L / S**2, 10 * L / S**2, 0.2 * L / S**2),
              ("2.coefficient", -20 * L / S, 20 * L / S, 0.3 * L / S)),
             ((0.0, 0.0),), MOVING,
             simpler="quadratic-drag", more=(ViscousDrag(**R),), further=True),
        candidate("bias-force", BiasForce(**R), (("bias", -40 * L, 40 * L, 0.5 * L),), ((0.0,),),
             ("time", "position", "direction")),
        candidate("imbalance", Imbalance(**R),
             (("cosine", -40 * L, 40 * L, 0.5 * L), ("sine", -40 * L, 40 * L, 0.5 * L)),
             ((0.0, 0.0),), ("position",)),
        candidate("imbalance-2", Imbalance(**R),
             (("1.cosine", -40 * L, 40 * L, 0.5 * L), ("1.sine", -40 * L, 40 * L, 0.5 * L),
              ("2.bias", -40 * L, 40 * L, 0.5 * L)),
             ((0.0, 0.0, 0.0),), ("position",),
             simpler="imbalance", more=(BiasForce(**R),)),
        *(candidate(f"imbalance-ripple-{n}", Imbalance(**R),
             tuple((name, -40 * L, 40 * L, 0.5 * L) for name in WAVES),
             ((0.0, 0.0, 0.0, 0.0),), ("position",),
             simpler="imbalance", more=(RippleForce(number=float(n), **R),),
             further=n in FURTHER_WAVES)
          for n in (2, *FURTHER_WAVES)),
        candidate("added-inertia", AddedInertia(**R),
             (("inertia_change", -0.6 * J, 3 * J, 0.03 * J),),
             ((0.0,),), ("acceleration",)),
    )  # fmt: skip


def of_the_sensor(sizes: Sizes) -> tuple[EffectCandidate, ...]:
    """Errors of the sensors that read the clutch's torque and, where it is logged, the motor's."""
    L = LBF_IN * sizes.torque
    return (
        sensor_candidate("sensor gain", ("gain", -0.3, 0.3, 0.01), 0.0, ("torque",)),
        sensor_candidate("sensor lag", ("lag", 0.0, 0.1, 0.002), 0.004,
                         ("excitation_rate", "acceleration", "drive"), "s"),
        replace(
            sensor_candidate("sensor delay", ("delay", -0.05, 0.1, 0.002), 0.004,
                             ("excitation_rate", "acceleration", "drive"), "s"),
            family="sensor lag", starts=((0.004,), (-0.004,))),
        sensor_candidate("sensor offset", ("offset", -40 * L, 40 * L, 0.5 * L), 0.0, ("time",),
                         "N*m"),
        sensor_candidate(f"{OF_MOTOR} gain", ("gain", -0.3, 0.3, 0.01), 0.0, ("torque",),
                         balances=("load",)),
        sensor_candidate(f"{OF_MOTOR} offset", ("offset", -40 * L, 40 * L, 0.5 * L), 0.0,
                         ("time",), "N*m", balances=("load",)),
    )  # fmt: skip
