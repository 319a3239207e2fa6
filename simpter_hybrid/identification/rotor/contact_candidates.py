"""Effects on the friction of a rotor's clutch, and where their fits begin."""

from __future__ import annotations

from ...effect import Effect
from ...effects.asymmetry import Asymmetry
from ...effects.clutch_backlash import ClutchBacklash
from ...effects.degressive_speed import DegressiveSpeed
from ...effects.drift import Drift
from ...effects.logarithmic_speed import LogarithmicSpeed
from ...effects.lugre import LuGre
from ...effects.maxwell_slip import MaxwellSlip
from ...effects.position_friction import PositionFriction
from ...effects.stribeck import Stribeck
from ...effects.thermal_fade import ThermalFade
from ...effects.warm_up import WarmUp
from ...effects.wear_in import WearIn
from ...laws import LBF_IN
from ..rigs.candidate import MOVING, candidate
from ..rigs.effect_candidate import EffectCandidate
from .sizes import Sizes
from .winding import Winding

C = {"clutch": 0}
#: Waves a turn that are tried where one or two are not enough: bolts, poles, slots.
FURTHER_WAVES = range(3, 13)
#: What a play and the ends of it give together is softer than these: so many times as stiff as
#: reversals show.  Of a play of a few steps of the encoder a fit begun at the softer ones stalls.
ENDS = (1.0, 5.0)
#: Where reversals tell nothing of what gives way.
WOUND = Winding(2e4 * LBF_IN, 5e-3)
REVERSING = ("displacement_since_reversal", *MOVING)


def of_speed_and_angle(sizes: Sizes) -> tuple[EffectCandidate, ...]:
    """Friction that depends on how fast, which way and where the clutch slips."""
    S = sizes.speed
    names = ("once_cos", "once_sin", "often_cos", "often_sin")
    waves = tuple((name, -0.5, 0.5, 0.02) for name in names)
    return (
        candidate("stribeck", Stribeck(**C),
             (("rise", -0.8, 1.5, 0.03), ("fade", 0.01 * S, 2.0 * S, 0.05 * S)),
             ((0.05, 0.03 * S), (0.05, 0.1 * S), (0.05, 0.4 * S)), MOVING),
        candidate("logarithmic-speed", LogarithmicSpeed(**C), (("rise", -0.4, 0.6, 0.02),),
             ((0.0,),), MOVING),
        candidate("degressive-speed", DegressiveSpeed(**C),
             (("rise", -0.8, 2.0, 0.03), ("scale", 0.02 * S, 5.0 * S, 0.1 * S)),
             ((0.05, 0.5 * S),), MOVING),
        candidate("asymmetry", Asymmetry(**C), (("share", -0.5, 0.5, 0.02),), ((0.0,),),
             ("direction", "slip_velocity")),
        candidate("position-friction", PositionFriction(**C), waves[:2], ((0.0, 0.0),),
             ("position",)),
        *(candidate(f"position-friction-{n}", PositionFriction(number=float(n), **C), waves,
               ((0.0, 0.0, 0.0, 0.0),), ("position",),
               simpler="position-friction", further=n in FURTHER_WAVES)
          for n in (2, *FURTHER_WAVES)),
    )  # fmt: skip


def giving_way(
    sizes: Sizes, wound: Winding | None, beside: tuple[int, ...]
) -> tuple[EffectCandidate, ...]:
    """Effects of what gives way before a clutch slips.

    `beside`: clutches that rub on the same plate, which give way with it.
    """
    L = LBF_IN * sizes.torque
    stiff = WOUND._replace(stiffness=WOUND.stiffness * sizes.torque)
    firm, wound = wound is None, wound or stiff

    def along(effect: type[Effect]) -> tuple[Effect, ...]:
        return tuple(effect(clutch=k) for k in beside)

    return (
        candidate("presliding", LuGre(**C),
             (("displacement", 5e-4, 0.5, 0.003), ("fade", 0.003, 1.0, 0.02),
              ("damping", 0.0, 0.3, 0.002)),
             ((0.01, 0.03, 0.005), (0.06, 0.03, 0.005)), REVERSING, more=along(LuGre)),
        candidate("presliding-2", LuGre(**C),
             (("displacement", 5e-4, 0.5, 0.003), ("fade", 0.003, 1.0, 0.02),
              ("damping", 0.0, 0.3, 0.002), ("exponent", 0.3, 6.0, 0.3),
              ("carried", 0.0, 1.0, 0.3)),
             ((0.01, 0.03, 0.005, 1.2, 0.7), (0.06, 0.03, 0.005, 1.2, 0.7),
              (0.01, 0.03, 0.005, 1.2, 0.1)),
             REVERSING, simpler="presliding", more=along(LuGre)),
        candidate("presliding-springs", MaxwellSlip(**C),
             (("stiffness", 500 * L, 1e6 * L, 1e3 * L), ("share", 0.0, 1.0, 0.05),
              ("steep", 0.0, 1.0, 0.05), ("fade", 0.003, 1.0, 0.005), ("shape", 1.0, 12.0, 1.0),
              ("damping", 0.0, 0.1, 5e-4)),
             ((wound.stiffness, 0.4, 0.6, 0.02, 6.0, 1e-3),
              (wound.stiffness, 0.7, 0.9, 0.02, 6.0, 1e-3)),
             REVERSING, more=along(MaxwellSlip), further=firm),
        candidate("backlash", ClutchBacklash(**C),
             (("gap", 0.0, 0.5, 1e-3), ("stiffness", 1e3 * L, 1e7 * L, 5e3 * L),
              ("damping", 0.0, 0.1, 1e-3)),
             tuple((max(wound.gap, 1e-3), times * wound.stiffness, damping)
                   for times in ENDS for damping in (1e-3, 1e-4)),
             REVERSING, more=along(ClutchBacklash), further=firm),
    )  # fmt: skip


def in_the_long_run(sizes: Sizes) -> tuple[EffectCandidate, ...]:
    """Friction that changes with time, heat and distance."""
    E = sizes.torque  # of energy
    return (
        candidate("drift", Drift(**C), (("rate_per_time", -0.05, 0.2, 0.001),), ((0.0,),),
             ("time",)),
        candidate("thermal-fade", ThermalFade(**C), (("fade", -0.8, 5.0, 0.03),
             ("cooling", 0.5, 100.0, 2.0)), ((0.05, 3.0), (0.05, 12.0)),
             ("heat",)),
        candidate("wear-in", WearIn(**C), (("change", -0.8, 1.0, 0.02), ("scale", 0.3, 100.0, 1.0)),
             ((0.02, 2.0), (0.02, 10.0)), ("distance",)),
        candidate("warm-up", WarmUp(**C),
             (("change", -0.8, 1.0, 0.02), ("energy", 5.0 * E, 1e3 * E, 20.0 * E)),
             ((0.03, 50.0 * E),), ("distance", "heat")),
    )  # fmt: skip
