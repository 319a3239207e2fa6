"""The library: effects that are tried on a rotor with a clutch, and where their fits begin."""

from __future__ import annotations

from dataclasses import replace

from ...effect import Effect
from ...effects.added_inertia import AddedInertia
from ...effects.asymmetry import Asymmetry
from ...effects.bias_force import BiasForce
from ...effects.clutch_backlash import ClutchBacklash
from ...effects.coil_supply import CoilSupply
from ...effects.command_scale import CommandScale
from ...effects.degressive_speed import DegressiveSpeed
from ...effects.drift import Drift
from ...effects.dwell_breakaway import DwellBreakaway
from ...effects.imbalance import Imbalance
from ...effects.logarithmic_speed import LogarithmicSpeed
from ...effects.lugre import LuGre
from ...effects.maxwell_slip import MaxwellSlip
from ...effects.neighbour_command import NeighbourCommand
from ...effects.play_hysteresis import PlayHysteresis
from ...effects.position_friction import PositionFriction
from ...effects.pull_in import PullIn
from ...effects.quadratic_drag import QuadraticDrag
from ...effects.release_asymmetry import ReleaseAsymmetry
from ...effects.remanence import Remanence
from ...effects.second_lag import SecondLag
from ...effects.slew_limit import SlewLimit
from ...effects.stribeck import Stribeck
from ...effects.thermal_fade import ThermalFade
from ...effects.torque_lag import TorqueLag
from ...effects.viscous_drag import ViscousDrag
from ...effects.warm_up import WarmUp
from ...effects.wear_in import WearIn
from ...laws import LBF_IN
from ..fitting.predictor import Parameter
from ..rigs.candidate import FURTHER_WAVES, candidate, sensor_candidate
from ..rigs.declared_off import TIME_CONSTANT
from ..rigs.effect_candidate import EffectCandidate
from .sizes import OF_TESTBED, Sizes
from .winding import Winding

#: Where a lack of what switches a clutch shows.
SWITCHING = ("excitation_rate", "drive")
#: Where reversals tell nothing of what gives way.
WOUND = Winding(2e4 * LBF_IN, 5e-3)


def rotor_candidates(
    beside: tuple[int, ...] = (),
    wound: Winding | None = WOUND,
    lag: str | None = None,
    sizes: Sizes = OF_TESTBED,
) -> tuple[EffectCandidate, ...]:
    """Every effect that is tried, one form after the other.

    `lag`: name of the tolerance to which the clutch's time constant is declared, if it is to one.

    `beside`: further friction surfaces of the same plate (what it drags when off), which give way
    with it.  `wound`: where fits of what gives way after reversals begin; where reversals show
    nothing that does, None: what would show there is then tried as a further form alone.  `sizes`:
    of the clutch and its rotor, beside those of the testbed.
    """
    L, V, J = LBF_IN * sizes.torque, sizes.command, LBF_IN * sizes.inertia
    E, S = sizes.torque, sizes.speed  # of energy and speed
    # Beside a limit of what drives a coil its lag is another than the one that held both.
    free = () if lag is None else (Parameter(lag, 1.0, 0.05, 1.7, 0.05),)
    slow = (0.01 / V, 0.01 / V)
    c, r = {"clutch": 0}, {"coordinate": 0}

    stiff = WOUND._replace(stiffness=WOUND.stiffness * sizes.torque)
    firm, wound = wound is None, wound or stiff

    def along(effect: type[Effect]) -> tuple[Effect, ...]:
        return tuple(effect(clutch=k) for k in beside)

    moving = ("speed", "slip_velocity")
    reversing = ("displacement_since_reversal", *moving)
    names = ("once_cos", "once_sin", "often_cos", "often_sin")
    waves = tuple((name, -0.5, 0.5, 0.02) for name in names)
    make = candidate
    return (
        make("stribeck", Stribeck(**c),
             (("rise", -0.8, 1.5, 0.03), ("fade", 0.01 * S, 2.0 * S, 0.05 * S)),
             ((0.05, 0.03 * S), (0.05, 0.1 * S), (0.05, 0.4 * S)), moving),
        make("logarithmic-speed", LogarithmicSpeed(**c), (("rise", -0.4, 0.6, 0.02),),
             ((0.0,),), moving),
        make("degressive-speed", DegressiveSpeed(**c),
             (("rise", -0.8, 2.0, 0.03), ("scale", 0.02 * S, 5.0 * S, 0.1 * S)),
             ((0.05, 0.5 * S),), moving),
        make("asymmetry", Asymmetry(**c), (("share", -0.5, 0.5, 0.02),), ((0.0,),),
             ("direction", "slip_velocity")),
        make("position-friction", PositionFriction(**c), waves[:2], ((0.0, 0.0),),
             ("position",)),
        *(make(f"position-friction-{n}", PositionFriction(number=float(n), **c), waves,
               ((0.0, 0.0, 0.0, 0.0),), ("position",),
               simpler="position-friction", further=n in FURTHER_WAVES)
          for n in (2, *FURTHER_WAVES)),
        make("presliding", LuGre(**c),
             (("displacement", 5e-4, 0.5, 0.003), ("fade", 0.003, 1.0, 0.02),
              ("damping", 0.0, 0.3, 0.002)),
             ((0.01, 0.03, 0.005), (0.06, 0.03, 0.005)), reversing, more=along(LuGre)),
        make("presliding-2", LuGre(**c),
             (("displacement", 5e-4, 0.5, 0.003), ("fade", 0.003, 1.0, 0.02),
              ("damping", 0.0, 0.3, 0.002), ("exponent", 0.3, 6.0, 0.3),
              ("carried", 0.0, 1.0, 0.3)),
             ((0.01, 0.03, 0.005, 1.2, 0.7), (0.06, 0.03, 0.005, 1.2, 0.7),
              (0.01, 0.03, 0.005, 1.2, 0.1)),
             reversing, simpler="presliding", more=along(LuGre)),
        make("presliding-springs", MaxwellSlip(**c),
             (("stiffness", 500 * L, 1e6 * L, 1e3 * L), ("share", 0.0, 1.0, 0.05),
              ("steep", 0.0, 1.0, 0.05), ("fade", 0.003, 1.0, 0.005), ("shape", 1.0, 12.0, 1.0),
              ("damping", 0.0, 0.1, 5e-4)),
             ((wound.stiffness, 0.4, 0.6, 0.02, 6.0, 1e-3),
              (wound.stiffness, 0.7, 0.9, 0.02, 6.0, 1e-3)),
             reversing, more=along(MaxwellSlip), further=firm),
        make("backlash", ClutchBacklash(**c),
             (("gap", 0.0, 0.5, 1e-3), ("stiffness", 1e3 * L, 1e7 * L, 5e3 * L),
              ("damping", 0.0, 0.1, 1e-3)),
             ((max(wound.gap, 1e-3), wound.stiffness, 1e-3),),
             reversing, more=along(ClutchBacklash), further=firm),
        make("drift", Drift(**c), (("rate_per_time", -0.05, 0.2, 0.001),), ((0.0,),),
             ("time",)),
        make("thermal-fade", ThermalFade(**c), (("fade", -0.8, 5.0, 0.03),
             ("cooling", 0.5, 100.0, 2.0)), ((0.05, 3.0), (0.05, 12.0)),
             ("heat",)),
        make("wear-in", WearIn(**c), (("change", -0.8, 1.0, 0.02), ("scale", 0.3, 100.0, 1.0)),
             ((0.02, 2.0), (0.02, 10.0)), ("distance",)),
        make("warm-up", WarmUp(**c),
             (("change", -0.8, 1.0, 0.02), ("energy", 5.0 * E, 1e3 * E, 20.0 * E)),
             ((0.03, 50.0 * E),), ("distance", "heat")),
        make("viscous-drag", ViscousDrag(**r),
             (("coefficient", -20 * L / S, 20 * L / S, 0.3 * L / S),),
             ((0.0,),), moving),
        make("quadratic-drag", QuadraticDrag(**r),
             (("coefficient", -10 * L / S**2, 10 * L / S**2, 0.2 * L / S**2),),
             ((0.0,),), moving),
        make("bias-force", BiasForce(**r), (("bias", -40 * L, 40 * L, 0.5 * L),), ((0.0,),),
             ("time", "position", "direction")),
        make("imbalance", Imbalance(**r),
             (("cosine", -40 * L, 40 * L, 0.5 * L), ("sine", -40 * L, 40 * L, 0.5 * L)),
             ((0.0, 0.0),), ("position",)),
        make("imbalance-2", Imbalance(**r),
             (("1.cosine", -40 * L, 40 * L, 0.5 * L), ("1.sine", -40 * L, 40 * L, 0.5 * L),
              ("2.bias", -40 * L, 40 * L, 0.5 * L)),
             ((0.0, 0.0, 0.0),), ("position",),
             simpler="imbalance", more=(BiasForce(**r),)),
        make("added-inertia", AddedInertia(**r), (("inertia_change", -0.6 * J, 3 * J, 0.03 * J),),
             ((0.0,),), ("acceleration",)),
        make("play-hysteresis", PlayHysteresis(**c),
             (("share", 0.0, 1.0, 0.05), ("width", 0.1 * V, 8.0 * V, 0.3 * V)),
             ((0.15, 1.0 * V), (0.15, 3.0 * V)), ("excitation_branch", "excitation_rate")),
        make("play-hysteresis-2", PlayHysteresis(**c),
             (("share", 0.0, 1.0, 0.05), ("width", 0.1 * V, 8.0 * V, 0.3 * V),
              ("lift", 0.0, 2.0, 0.2)),
             ((0.15, 1.0 * V, 0.7), (0.15, 3.0 * V, 0.7)),
             ("excitation_branch", "excitation_rate"), simpler="play-hysteresis"),
        make("remanence", Remanence(**c), (("width", 0.0, 2.0 * V, 0.03 * V),), ((0.05 * V,),),
             ("excitation_branch", "excitation_rate")),
        make("slew-limit", SlewLimit(**c),
             (("slowness", 0.0, 0.2 / V, 0.001 / V), ("slowness_down", 0.0, 0.2 / V, 0.001 / V)),
             (slow if lag is None else (*slow, 0.3),), SWITCHING, free, contains=(TIME_CONSTANT,)),
        make("coil-supply", CoilSupply(**c),
             (("inductive", 0.01, 0.5, 0.005), ("clamp", 10.0 * V, 60.0 * V, 0.5 * V),
              ("stiffness", 0.0, 50.0, 0.5)), ((0.124, 15.0 * V, 3.0),),
             SWITCHING, contains=(TIME_CONSTANT,)),
        make("release-asymmetry", ReleaseAsymmetry(**c), (("share", -0.8, 3.0, 0.05),), ((0.0,),),
             SWITCHING),
        make("torque-lag", TorqueLag(**c), (("share", 0.0, 1.0, 0.05),), ((0.1,),),
             SWITCHING),
        make("second-lag", SecondLag(**c), (("lag", 1e-4, 0.1, 0.002),), ((0.005,),),
             SWITCHING),
        make("pull-in", PullIn(**c), (("extra", -0.02, 0.1, 0.002), ("drop_out", 0.0, V, 0.02 * V)),
             ((0.0, 0.0),), SWITCHING),
        make("neighbour-command", NeighbourCommand(**c), (("gain", -0.8, 0.8, 0.02),), ((0.0,),),
             ("neighbour_command",)),
        replace(
            make("neighbour-command-2", NeighbourCommand(**c),
                 (("gain", -0.8, 0.8, 0.02), ("lag", 1e-3, 0.5, 0.01)),
                 ((0.02, 0.02), (-0.02, 0.02)), ("neighbour_command",),
                 simpler="neighbour-command"),
            plain="neighbour-command"),
        make("command-scale", CommandScale(**c),
             (("gain", -0.5, 0.5, 0.01), ("offset", -2.0 * V, 2.0 * V, 0.02 * V)),
             ((0.0, 0.0),), ("excitation", "torque")),
        make("dwell-breakaway", DwellBreakaway(**c), (("rise", 0.0, 0.5, 0.01),), ((0.02,),),
             ("rest", "level")),
        sensor_candidate("sensor gain", ("gain", -0.3, 0.3, 0.01), 0.0, ("torque",)),
        sensor_candidate("sensor lag", ("lag", 0.0, 0.1, 0.002), 0.004,
                         ("excitation_rate", "acceleration", "drive"), "s"),
        sensor_candidate("sensor offset", ("offset", -40 * L, 40 * L, 0.5 * L), 0.0, ("time",),
                         "N*m"),
    )  # fmt: skip
