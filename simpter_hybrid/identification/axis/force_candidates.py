"""Forces on one driven axis, and its inertia, with sizes taken from the recorded motion."""

from __future__ import annotations

import math
from collections.abc import Mapping

from ...effects.added_inertia import AddedInertia
from ...effects.bias_drift import BiasDrift
from ...effects.bias_force import BiasForce
from ...effects.eddy_drag import EddyDrag
from ...effects.end_spring import EndSpring
from ...effects.imbalance import Imbalance
from ...effects.load_dependent import LoadDependent
from ...effects.position_friction import PositionFriction
from ...effects.power_law_drag import PowerLawDrag
from ...effects.quadratic_drag import QuadraticDrag
from ...effects.rotor_load import RotorLoad
from ...effects.spring_force import SpringForce
from ...effects.viscous_drag import ViscousDrag
from ..rigs.candidate import candidate
from ..rigs.effect_candidate import EffectCandidate
from .friction_candidates import MOVING, C
from .sizes import AxisSizes
from .wave_candidates import WAVES, waves_a_turn

#: Part of the way on which a spring at an end does not act, at the least.
LEAST_FREE = 0.1
#: Where springs at the ends are looked for, in parts of the way from its middle.
FROM_MIDDLE = (0.0, 0.2, 0.35, 0.45)
R = {"coordinate": 0}


def drags(sizes: AxisSizes) -> tuple[EffectCandidate, ...]:
    """Forces against the motion that grow with speed."""
    v, f = sizes.speed, sizes.force
    return (
        candidate("viscous-drag", ViscousDrag(**R),
             (("coefficient", -f / v, 20 * f / v, 0.02 * f / v),), ((0.0,),),
             MOVING),
        candidate("quadratic-drag", QuadraticDrag(**R),
             (("coefficient", -f / v**2, 20 * f / v**2, 0.02 * f / v**2),), ((0.0,),),
             MOVING),
        candidate("eddy-drag", EddyDrag(**R),
             (("peak", -f, 20 * f, 0.02 * f), ("critical", 0.02 * v, 5 * v, 0.05 * v)),
             ((0.1 * f, 0.2 * v), (0.1 * f, 0.6 * v)), MOVING,
             simpler="viscous-drag", contains=("viscous-drag",)),
        candidate("power-law-drag", PowerLawDrag(scale=v, **R),
             (("level", -f, 20 * f, 0.02 * f), ("exponent", 1.0, 8.0, 0.2)),
             ((0.1 * f, 2.0), (0.1 * f, 4.0)), MOVING,
             simpler="quadratic-drag", contains=("viscous-drag",), further=True),
    )  # fmt: skip


def of_place(
    sizes: AxisSizes, spring: tuple[tuple[float, float], ...]
) -> tuple[EffectCandidate, ...]:
    """A constant force, and springs.

    `spring`: stiffness and rest from which one is looked for as well.
    """
    f, travel, middle = sizes.force, sizes.travel, sizes.middle
    # A counterweight's spring rests at an end of the way: none small leads there from the middle.
    begins = tuple(
        (0.5 * f / travel, min(max(rest, middle - 20 * travel), middle + 20 * travel))
        for rest in (sizes.low, sizes.high)
    )
    begins = ((0.1 * f / travel, middle), (-0.1 * f / travel, middle), *begins, *spring)
    constant = candidate(
        "bias-force", BiasForce(**R), (("bias", -5 * f, 5 * f, 0.02 * f),), ((0.0,),),
        ("direction", "time", "position", "slip_velocity"),
    )  # fmt: skip
    if sizes.one_way:
        return (constant,)
    most = 5 * f / sizes.duration
    drifts = candidate(
        "bias-drift", BiasDrift(**R),
        (("bias", -5 * f, 5 * f, 0.02 * f), ("rate", -most, most, 0.01 * most)),
        ((0.0, 0.01 * most), (0.0, -0.01 * most)), ("time",),
        simpler="bias-force", contains=("bias-force",),
    )  # fmt: skip
    # One way friction that changes with time does the same.
    known = (constant,) if sizes.slides else (constant, drifts)
    return (
        *known,
        candidate("spring-force", SpringForce(**R),
             (("stiffness", -2 * f / travel, 20 * f / travel, 0.02 * f / travel),
              ("rest", middle - 20 * travel, middle + 20 * travel, 0.05 * travel)),
             begins, ("position",), contains=("bias-force",)),
        candidate("spring-force-3", SpringForce(**R),
             (("stiffness", -2 * f / travel, 20 * f / travel, 0.02 * f / travel),
              ("rest", middle - 20 * travel, middle + 20 * travel, 0.05 * travel),
              ("stiffening", -100 * f / travel**3, 400 * f / travel**3, 0.1 * f / travel**3)),
             tuple((*begin, 0.0) for begin in begins),
             ("position",), simpler="spring-force", contains=("bias-force",)),
    )  # fmt: skip


def of_weight() -> EffectCandidate:
    """Friction that grows with what gravity and springs alone load, as that of a bearing does."""
    effect = LoadDependent(**C, external=1.0, driven=0.0)
    fields = (("rise", 0.0, 0.9, 0.02),)
    return candidate(
        "weight-dependent", effect, fields, ((0.03,), (0.2,)), ("position", "direction")
    )


def of_load(sizes: AxisSizes) -> tuple[EffectCandidate, ...]:
    """Another inertia, and friction that grows with what is carried."""
    inertia = sizes.inertia
    return (
        candidate("added-inertia", AddedInertia(**R),
             (("inertia_change", -0.7 * inertia, 10 * inertia, 0.02 * inertia),), ((0.0,),),
             ("acceleration",)),
        candidate("load-dependent", LoadDependent(**C), (("rise", 0.0, 0.9, 0.02),), ((0.03,),),
             ("torque", "acceleration")),
        candidate("load-dependent-2", LoadDependent(**C),
             (("rise", 0.0, 0.9, 0.02), ("external", 0.0, 1.0, 0.1)), ((0.03, 0.5), (0.03, 1.0)),
             ("torque", "acceleration"), simpler="load-dependent",
             further=True),
        candidate("load-dependent-rotor", RotorLoad(**C),
             (("rise", 0.0, 0.9, 0.02), ("rotor", 0.0, inertia, 0.02 * inertia)),
             ((0.03, 0.3 * inertia),), ("torque", "acceleration"),
             simpler="load-dependent", further=True),
    )  # fmt: skip


def of_ends(
    sizes: AxisSizes, met: Mapping[float, tuple[float, float] | None]
) -> list[EffectCandidate]:
    """Springs at the ends of the way, if it has any.

    `met`: side -> stiffness over inertia and place from which one at that end is.
    """
    f, travel, low, high = sizes.force, sizes.travel, sizes.low, sizes.high
    found: list[EffectCandidate] = []
    if math.isfinite(sizes.turn):
        return found  # a way that comes again has none
    for end, side in (("high", 1.0), ("low", -1.0)):
        # One that acts on nearly all of the way is a spring, and at no end.
        free = side * LEAST_FREE * (high - low)
        edges = (low + max(free, 0.0), high + min(free, 0.0))
        begins = [(0.5 * f / travel, sizes.middle + side * p * (high - low)) for p in FROM_MIDDLE]
        if (seen := met.get(side)) is not None:
            begins = [(sizes.inertia * seen[0], seen[1]), *begins]
        begins = [(k, min(max(edge, edges[0]), edges[1])) for k, edge in begins]
        most = max(200 * f / travel, *(10.0 * k for k, _ in begins))
        found.append(
            candidate(f"end-spring-{end}", EndSpring(side=side, **R),
                 (("stiffness", 0.0, most, 0.05 * f / travel), ("edge", *edges, 0.02 * travel)),
                 tuple(begins), ("position",))
        )  # fmt: skip
    return found


def of_turns(sizes: AxisSizes) -> tuple[EffectCandidate, ...]:
    """Candidates of friction and forces that repeat with every turn."""
    f, way = sizes.force, sizes.high - sizes.low
    once = (
        candidate("imbalance", Imbalance(**R), (("cosine", -5 * f, 5 * f, 0.02 * f),
             ("sine", -5 * f, 5 * f, 0.02 * f)), ((0.0, 0.0),),
             ("position",)),
        candidate("position-friction", PositionFriction(**C), (("once_cos", -0.8, 0.8, 0.03),
             ("once_sin", -0.8, 0.8, 0.03)), ((0.0, 0.0),),
             ("position",)),
    )  # fmt: skip
    whole = (n for n in WAVES if n * way >= 2 * math.pi)
    return (*once, *(e for n in whole for e in waves_a_turn(n, f)))
