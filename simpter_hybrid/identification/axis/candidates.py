"""Effects that are tried on one driven axis, with sizes taken from the recorded motion."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType

from ...effects.added_inertia import AddedInertia
from ...effects.asymmetry import Asymmetry
from ...effects.bias_force import BiasForce
from ...effects.dahl import Dahl
from ...effects.degressive_speed import DegressiveSpeed
from ...effects.drift import Drift
from ...effects.eddy_drag import EddyDrag
from ...effects.end_spring import EndSpring
from ...effects.imbalance import Imbalance
from ...effects.load_dependent import LoadDependent
from ...effects.logarithmic_speed import LogarithmicSpeed
from ...effects.lugre import LuGre
from ...effects.position_friction import PositionFriction
from ...effects.quadratic_drag import QuadraticDrag
from ...effects.rotor_load import RotorLoad
from ...effects.settling import Settling
from ...effects.spring_force import SpringForce
from ...effects.stribeck import Stribeck
from ...effects.thermal_fade import ThermalFade
from ...effects.viscous_drag import ViscousDrag
from ...effects.warm_up import WarmUp
from ...scenario import Scenario
from ..rigs.candidate import Field, candidate
from ..rigs.declared_off import with_scale
from ..rigs.effect_candidate import EffectCandidate
from .position_waves import Wave
from .wave_candidates import WAVES, any_wave, waves_a_turn

#: Where springs at the ends are looked for, in parts of the way from its middle.
FROM_MIDDLE = (0.0, 0.2, 0.35, 0.45)
#: The name of dry friction off its declared size, where no clutch is switched.
FRICTION_SCALE = "friction-scale"
#: What tells of an effect where no motion of the axis does.
OTHERWISE = {
    "added-inertia": "The same runs with a known mass added.",
    "asymmetry": "The same runs with the friction pressed more, or less.",
    "asymmetry-level": "The same runs with the axis turned round.",
    "bias-force": "The same runs with the axis turned round.",
}
#: Words of experiments with clutches that say nothing of an axis.
NO_CLUTCH = (", with all clutches off", " with all clutches off", " with clutches off",
             ", at constant excitation", " at constant excitation", ", at several excitations",
             " and excitation")  # fmt: skip
#: What turns, and what slides instead.
SLIDES = {"Spin up to": "Go up to", "Spin at": "Move at", "Slow turns": "Slow strokes",
          "slow turns": "slow strokes"}  # fmt: skip


def axis_candidates(
    speed: float,
    force: float,
    travel: float,
    duration: float,
    inertia: float,
    turning: bool,
    low: float = 0.0,
    high: float = 0.0,
    waves: Sequence[tuple[Wave, Wave]] = (),
    spring: tuple[tuple[float, float], ...] = (),
    met: Mapping[float, tuple[float, float] | None] = MappingProxyType({}),
) -> tuple[EffectCandidate, ...]:
    """The library for one axis.

    Parameters
    ----------
    speed, force, travel : float
        Largest speed, friction or drive force, and travel in the record [SI].
    duration : float
        Of the longest run [s].
    inertia : float
        Declared.
    turning : bool
        Whether the coordinate is an angle.
    low, high : float
        Ends of the coordinate in all of the record: a spring's rest is looked for from the middle
        on.
    waves : sequence of (Wave, Wave)
        Of friction and of a force, that recorded motions show best.
    spring : tuple of (float, float)
        Stiffness and rest from which a spring is looked for as well.
    met : mapping of float to (float, float)
        Side -> stiffness over inertia and place from which one at that end is.
    """
    c, r = {"clutch": 0}, {"coordinate": 0}
    v, f, middle = speed, force, 0.5 * (low + high)
    moving = ("speed", "slip_velocity")
    make = candidate
    found = [
        make("stribeck", Stribeck(**c),
             (("rise", -0.8, 3.0, 0.05), ("fade", 0.005 * v, v, 0.03 * v)),
             ((0.1, 0.02 * v), (0.1, 0.06 * v), (0.1, 0.2 * v), (0.4, 0.06 * v), (0.4, 0.2 * v)),
             moving),
        make("stribeck-2", Stribeck(**c),
             (("rise", -0.8, 3.0, 0.05), ("fade", 0.005 * v, v, 0.03 * v),
              ("shape", 0.5, 4.0, 0.2)),
             ((0.1, 0.02 * v, 2.0), (0.1, 0.2 * v, 2.0)), moving,
             simpler="stribeck"),
        make("logarithmic-speed", LogarithmicSpeed(scale=0.03 * v, **c),
             (("rise", -0.4, 1.0, 0.03),), ((0.0,),), moving),
        make("degressive-speed", DegressiveSpeed(**c),
             (("rise", -0.8, 5.0, 0.05), ("scale", 0.01 * v, 3 * v, 0.05 * v)),
             ((0.1, 0.3 * v),), moving, contains=("viscous-drag",)),
        make("asymmetry", Asymmetry(**c), (("share", -0.8, 0.8, 0.03),), ((0.0,),),
             ("direction", "slip_velocity")),
        # What is viscous stays: a constant force does the same.
        make("asymmetry-level", Asymmetry(**c), (("level", -2 * f, 2 * f, 0.02 * f),), ((0.0,),),
             ("direction", "slip_velocity")),
        make("presliding", Dahl(**c),
             (("displacement", 2e-4 * travel, 0.5 * travel, 2e-3 * travel),),
             ((5e-4 * travel,), (0.003 * travel,), (0.03 * travel,)),
             ("displacement_since_reversal", *moving)),
        make("presliding-2", LuGre(fade=0.02 * v, **c),
             (("displacement", 2e-4 * travel, 0.5 * travel, 2e-3 * travel),
              ("damping", 0.0, travel / v, 2e-4 * travel / v), ("exponent", 0.3, 6.0, 0.3)),
             ((0.003 * travel, 0.0, 1.5), (0.03 * travel, 0.0, 1.5)),
             ("displacement_since_reversal", *moving), simpler="presliding"),
        make("drift", Drift(**c), (("rate_per_time", -0.9 / duration, 5.0 / duration,
             0.02 / duration),), ((0.0,),), ("time",)),
        make("settling", Settling(**c), (("amount", -2 * f, 2 * f, 0.02 * f), ("constant",
             0.02 * duration, 2 * duration, 0.05 * duration)),
             ((0.1 * f, 0.1 * duration), (0.1 * f, 0.4 * duration)), ("time",), simpler="drift"),
        make("viscous-drag", ViscousDrag(**r),
             (("coefficient", -f / v, 20 * f / v, 0.02 * f / v),), ((0.0,),),
             moving),
        make("quadratic-drag", QuadraticDrag(**r),
             (("coefficient", -f / v**2, 20 * f / v**2, 0.02 * f / v**2),), ((0.0,),),
             moving),
        make("eddy-drag", EddyDrag(**r),
             (("peak", -f, 20 * f, 0.02 * f), ("critical", 0.02 * v, 5 * v, 0.05 * v)),
             ((0.1 * f, 0.2 * v), (0.1 * f, 0.6 * v)), moving,
             simpler="viscous-drag", contains=("viscous-drag",)),
        make("bias-force", BiasForce(**r), (("bias", -5 * f, 5 * f, 0.02 * f),), ((0.0,),),
             ("direction", "time", "position", "slip_velocity")),
        make("spring-force", SpringForce(**r),
             (("stiffness", -2 * f / travel, 20 * f / travel, 0.02 * f / travel),
              ("rest", middle - 20 * travel, middle + 20 * travel, 0.05 * travel)),
             ((0.1 * f / travel, middle), (-0.1 * f / travel, middle), *spring),
             ("position",), contains=("bias-force",)),
        make("spring-force-3", SpringForce(**r),
             (("stiffness", -2 * f / travel, 20 * f / travel, 0.02 * f / travel),
              ("rest", middle - 20 * travel, middle + 20 * travel, 0.05 * travel),
              ("stiffening", -100 * f / travel**3, 400 * f / travel**3, 0.1 * f / travel**3)),
             tuple((*begin, 0.0) for begin in
                   ((0.1 * f / travel, middle), (-0.1 * f / travel, middle), *spring)),
             ("position",), simpler="spring-force", contains=("bias-force",)),
        make("added-inertia", AddedInertia(**r),
             (("inertia_change", -0.7 * inertia, 10 * inertia, 0.02 * inertia),), ((0.0,),),
             ("acceleration",)),
        make("load-dependent", LoadDependent(**c), (("rise", 0.0, 0.9, 0.02),), ((0.03,),),
             ("torque", "acceleration")),
        make("load-dependent-2", LoadDependent(**c),
             (("rise", 0.0, 0.9, 0.02), ("external", 0.0, 1.0, 0.1)), ((0.03, 0.5), (0.03, 1.0)),
             ("torque", "acceleration"), simpler="load-dependent",
             further=True),
        make("load-dependent-rotor", RotorLoad(**c),
             (("rise", 0.0, 0.9, 0.02), ("rotor", 0.0, inertia, 0.02 * inertia)),
             ((0.03, 0.3 * inertia),), ("torque", "acceleration"),
             simpler="load-dependent", further=True),
        make("warm-up", WarmUp(**c), (("change", -0.8, 1.0, 0.03), ("energy", 1e-2 * f * travel,
             1e3 * f * travel, 0.03 * f * travel)),
             ((0.05, 0.2 * f * travel), (0.05, 2 * f * travel), (0.05, 20 * f * travel)),
             ("distance", "heat", "time")),
        make("thermal-fade", ThermalFade(energy=10 * f * travel, **c),
             (("fade", -0.8, 10.0, 0.03), ("cooling", 0.02 * duration, 20 * duration,
              0.1 * duration)),
             ((0.1, 0.2 * duration), (0.1, 2 * duration)), ("heat", "time")),
    ]  # fmt: skip
    found += _curves(v, f)
    round_and_round = turning and high - low > 2 * math.pi  # such a way has no ends
    for end, side in (("high", 1.0), ("low", -1.0)) if not round_and_round else ():
        begins = [(0.5 * f / travel, middle + side * part * (high - low)) for part in FROM_MIDDLE]
        if (seen := met.get(side)) is not None:
            begins = [(inertia * seen[0], seen[1]), *begins]
        most = max(200 * f / travel, *(10.0 * k for k, _ in begins))
        found.append(
            make(f"end-spring-{end}", EndSpring(side=side, **r),
                 (("stiffness", 0.0, most, 0.05 * f / travel), ("edge", low, high, 0.02 * travel)),
                 tuple(begins), ("position",))
        )  # fmt: skip
    if turning:
        found += [
            make("imbalance", Imbalance(**r), (("cosine", -5 * f, 5 * f, 0.02 * f),
                 ("sine", -5 * f, 5 * f, 0.02 * f)), ((0.0, 0.0),),
                 ("position",)),
            make("position-friction", PositionFriction(**c), (("once_cos", -0.8, 0.8, 0.03),
                 ("once_sin", -0.8, 0.8, 0.03)), ((0.0, 0.0),),
                 ("position",)),
        ]  # fmt: skip
        whole = (n for n in WAVES if n * (high - low) >= 2 * math.pi)
        found += [e for n in whole for e in waves_a_turn(n, f)]
    if waves:
        found += any_wave(waves, force, inertia, travel)
    return tuple(
        replace(of_one_balance(e), experiment=OTHERWISE.get(e.name, of_axis(e.experiment, turning)))
        for e in found
    )


def of_axis(experiment: str, turning: bool) -> str:
    """Words of an experiment for an axis: it has no clutch, and what slides does not spin."""
    for clutch in NO_CLUTCH:
        experiment = experiment.replace(clutch, "")
    if not turning:
        for turns, slides in SLIDES.items():
            experiment = experiment.replace(turns, slides)
    return experiment


def with_friction_scale(
    library: Sequence[EffectCandidate], declared: Scenario
) -> tuple[EffectCandidate, ...]:
    """The library, and dry friction that is off what was declared by more than its tolerance."""
    where, test = ("force:direction", "force:slip_velocity"), "A slow sweep both ways."
    return with_scale(library, declared, FRICTION_SCALE, 10.0, where, test)


def _curves(v: float, f: float) -> list[EffectCandidate]:
    """Friction that falls and rises again: found one after the other each hides behind the other.

    With a free shape where it is the best and leaves more than noise.
    """
    drag: Field = ("2.coefficient", -f / v, 20 * f / v, 0.02 * f / v)
    made: list[EffectCandidate] = []
    for more, shape, begin in (("", (), ()), ("-2", (("1.shape", 0.5, 4.0, 0.2),), (2.0,))):
        fields = (("1.rise", -0.8, 3.0, 0.05), ("1.fade", 0.005 * v, v, 0.03 * v), *shape, drag)
        starts = tuple((0.1, at * v, *begin, 0.05 * f / v) for at in (0.02, 0.2))
        one = candidate(
            f"stribeck-viscous{more}", Stribeck(clutch=0), fields, starts,
            ("speed", "slip_velocity"), simpler=f"stribeck{more}", further=bool(more),
            more=(ViscousDrag(coordinate=0),),
            contains=("viscous-drag", *(c.name for c in made)),
        )  # fmt: skip
        sizes = tuple(f"{one.name}.{field}" for field in ("1.rise", "2.coefficient"))
        made.append(replace(one, sizes=sizes, plain="stribeck"))
    return made


def of_one_balance(one: EffectCandidate) -> EffectCandidate:
    """The same, where friction and load show in the same place: the one balance ``force``."""
    return replace(one, coordinates=tuple(f"force:{n.partition(':')[2]}" for n in one.coordinates))
