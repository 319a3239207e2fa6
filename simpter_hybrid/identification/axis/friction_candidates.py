"""Effects on the dry friction of one driven axis, with sizes taken from the recorded motion."""

from __future__ import annotations

from dataclasses import replace

from ...effects.asymmetry import Asymmetry
from ...effects.dahl import Dahl
from ...effects.degressive_speed import DegressiveSpeed
from ...effects.drift import Drift
from ...effects.dwell_breakaway import DwellBreakaway
from ...effects.logarithmic_speed import LogarithmicSpeed
from ...effects.lugre import LuGre
from ...effects.settling import Settling
from ...effects.stribeck import Stribeck
from ...effects.thermal_fade import ThermalFade
from ...effects.viscous_drag import ViscousDrag
from ...effects.warm_up import WarmUp
from ..rigs.candidate import MOVING, Field, candidate
from ..rigs.effect_candidate import EffectCandidate
from .sizes import AxisSizes

C = {"clutch": 0}


def of_speed(sizes: AxisSizes) -> tuple[EffectCandidate, ...]:
    """Friction that depends on how fast and which way the axis moves."""
    v, f = sizes.speed, sizes.force
    return (
        candidate("stribeck", Stribeck(**C),
             (("rise", -0.8, 3.0, 0.05), ("fade", 0.005 * v, v, 0.03 * v)),
             ((0.1, 0.02 * v), (0.1, 0.06 * v), (0.1, 0.2 * v), (0.4, 0.06 * v), (0.4, 0.2 * v)),
             MOVING),
        candidate("stribeck-2", Stribeck(**C),
             (("rise", -0.8, 3.0, 0.05), ("fade", 0.005 * v, v, 0.03 * v),
              ("shape", 0.5, 4.0, 0.2)),
             ((0.1, 0.02 * v, 2.0), (0.1, 0.2 * v, 2.0)), MOVING,
             simpler="stribeck"),
        candidate("logarithmic-speed", LogarithmicSpeed(scale=0.03 * v, **C),
             (("rise", -0.4, 1.0, 0.03),), ((0.0,),), MOVING),
        candidate("degressive-speed", DegressiveSpeed(**C),
             (("rise", -0.8, 5.0, 0.05), ("scale", 0.01 * v, 3 * v, 0.05 * v)),
             ((0.1, 0.3 * v),), MOVING, contains=("viscous-drag",)),
        candidate("asymmetry", Asymmetry(**C), (("share", -0.8, 0.8, 0.03),), ((0.0,),),
             ("direction", "slip_velocity")),
        # What is viscous stays: a constant force does the same.
        candidate("asymmetry-level", Asymmetry(**C), (("level", -2 * f, 2 * f, 0.02 * f),),
             ((0.0,),), ("direction", "slip_velocity")),
    )  # fmt: skip


def giving_way(sizes: AxisSizes) -> tuple[EffectCandidate, ...]:
    """Friction that gives way before it slips: it has to rest, or turn round, to show.

    Where it never does, a bristle that is not bent yet when a run begins would stand for a release
    that comes late: of a propeller's coast-down it was 60 turns long.
    """
    v, travel = sizes.speed, sizes.travel
    if sizes.slides:
        return ()
    return (
        candidate("presliding", Dahl(**C),
             (("displacement", 2e-4 * travel, 0.5 * travel, 2e-3 * travel),),
             ((5e-4 * travel,), (0.003 * travel,), (0.03 * travel,)),
             ("displacement_since_reversal", *MOVING)),
        candidate("presliding-2", LuGre(fade=0.02 * v, **C),
             (("displacement", 2e-4 * travel, 0.5 * travel, 2e-3 * travel),
              ("damping", 0.0, travel / v, 2e-4 * travel / v), ("exponent", 0.3, 6.0, 0.3)),
             ((0.003 * travel, 0.0, 1.5), (0.03 * travel, 0.0, 1.5)),
             ("displacement_since_reversal", *MOVING), simpler="presliding"),
    )  # fmt: skip


def after_rest(sizes: AxisSizes) -> tuple[EffectCandidate, ...]:
    """Friction that holds the more the longer it has rested."""
    travel, duration = sizes.travel, sizes.duration
    return (
        candidate("dwell-breakaway", DwellBreakaway(**C),
             (("rise", 0.0, 1.0, 0.02), ("onset", 1e-4 * duration, 0.2 * duration, 2e-3 * duration),
              ("distance", 1e-4 * travel, 0.3 * travel, 2e-3 * travel)),
             ((0.05, 0.01 * duration, 2e-3 * travel), (0.2, 0.01 * duration, 0.02 * travel)),
             ("displacement_since_reversal", *MOVING)),
    )  # fmt: skip


def in_time(sizes: AxisSizes) -> tuple[EffectCandidate, ...]:
    """Friction that changes with time alone."""
    f, duration = sizes.force, sizes.duration
    return (
        candidate("drift", Drift(**C), (("rate_per_time", -0.9 / duration, 5.0 / duration,
             0.02 / duration),), ((0.0,),), ("time",)),
        candidate("settling", Settling(**C), (("amount", -2 * f, 2 * f, 0.02 * f), ("constant",
             0.02 * duration, 2 * duration, 0.05 * duration)),
             ((0.1 * f, 0.1 * duration), (0.1 * f, 0.4 * duration)), ("time",), simpler="drift"),
    )  # fmt: skip


def with_heat(sizes: AxisSizes) -> tuple[EffectCandidate, ...]:
    """Friction that changes with what was dissipated."""
    f, travel, duration = sizes.force, sizes.travel, sizes.duration
    return (
        candidate("warm-up", WarmUp(**C),
             (("change", -0.8, 1.0, 0.03),
              ("energy", 1e-2 * f * travel, 1e3 * f * travel, 0.03 * f * travel)),
             ((0.05, 0.2 * f * travel), (0.05, 2 * f * travel), (0.05, 20 * f * travel)),
             ("distance", "heat", "time")),
        candidate("thermal-fade", ThermalFade(energy=10 * f * travel, **C),
             (("fade", -0.8, 200.0, 0.03), ("cooling", 0.02 * duration, 20 * duration,
              0.1 * duration)),
             ((0.1, 0.2 * duration), (0.1, 2 * duration)), ("heat", "time")),
    )  # fmt: skip


def falling_and_rising(sizes: AxisSizes) -> list[EffectCandidate]:
    """Friction that falls and rises again: found one after the other each hides behind the other.

    With a free shape where it is the best and leaves more than noise.
    """
    v, f = sizes.speed, sizes.force
    drag: Field = ("2.coefficient", -f / v, 20 * f / v, 0.02 * f / v)
    made: list[EffectCandidate] = []
    for more, shape, begin in (("", (), ()), ("-2", (("1.shape", 0.5, 4.0, 0.2),), (2.0,))):
        fields = (("1.rise", -0.8, 3.0, 0.05), ("1.fade", 0.005 * v, v, 0.03 * v), *shape, drag)
        starts = tuple((0.1, at * v, *begin, 0.05 * f / v) for at in (0.02, 0.2))
        one = candidate(
            f"stribeck-viscous{more}", Stribeck(clutch=0), fields, starts,
            MOVING, simpler=f"stribeck{more}", further=bool(more),
            more=(ViscousDrag(coordinate=0),),
            contains=("viscous-drag", *(c.name for c in made)),
        )  # fmt: skip
        told = tuple(f"{one.name}.{field}" for field in ("1.rise", "2.coefficient"))
        made.append(replace(one, sizes=told, plain="stribeck"))
    return made
