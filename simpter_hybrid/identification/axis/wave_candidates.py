"""Friction and forces that repeat along an axis, as effects that are tried."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from ...effects.position_friction import PositionFriction
from ...effects.ripple_force import RippleForce
from ...effects.surface_wave import SurfaceWave
from ..rigs.candidate import Field, candidate
from ..rigs.effect_candidate import EffectCandidate
from ..tracing.rivals import LEAST_FURTHER
from .position_waves import AGAIN, Wave

#: Waves a turn that are looked for, where a record passes a whole one.
WAVES = range(2, 9)
#: Long waves of friction at which fits begin beside the one that shows best: so many in the way.
LONG = (1.0, 1.5, 2.0, 3.0)


def waves_a_turn(number: int, force: float) -> list[EffectCandidate]:
    """Friction and a force that repeat so many times a turn: bolts, bearings, teeth, poles."""
    friction = PositionFriction(number=float(number), clutch=0)
    return [
        candidate(f"position-friction-{number}", friction,
                  (("often_cos", -0.8, 0.8, 0.03), ("often_sin", -0.8, 0.8, 0.03)),
                  ((0.0, 0.0),), ("position",)),
        candidate(f"ripple-force-{number}", RippleForce(number=float(number), coordinate=0),
                  (("cosine", -5 * force, 5 * force, 0.02 * force),
                   ("sine", -5 * force, 5 * force, 0.02 * force)),
                  ((0.0, 0.0),), ("position",)),
    ]  # fmt: skip


def any_wave(
    waves: Sequence[tuple[Wave, Wave]], force: float, inertia: float, travel: float
) -> list[EffectCandidate]:
    """Friction and a force that repeat after any length (a screw, a belt, balls of a bearing).

    Fits begin at the waves that were seen, and at a few long ones: noisy accelerations tell no long
    wave of friction, whole courses do.
    """
    (friction, push), *_ = waves
    seen = tuple(
        (*(min(max(x, -0.7), 0.7) for x in (wave.cosine, wave.sine)), wave.number)
        for wave, _ in waves
    )
    once = 2 * math.pi / travel
    starts = (*seen, *((0.1, 0.1, times * once) for times in LONG))
    pushes = tuple((inertia * p.cosine, inertia * p.sine, p.number) for _, p in waves)
    made = [
        candidate("position-friction-wave", PositionFriction(number=friction.number, clutch=0),
                  (("often_cos", -0.8, 0.8, 0.03), ("often_sin", -0.8, 0.8, 0.03),
                   number_field(starts, travel)), starts, ("position",)),
        candidate("surface-wave", SurfaceWave(number=friction.number, clutch=0),
                  (("cosine", -2 * force, 2 * force, 0.02 * force),
                   ("sine", -2 * force, 2 * force, 0.02 * force), number_field(starts, travel)),
                  tuple((0.2 * force * a, 0.2 * force * b, n) for a, b, n in starts),
                  ("position",)),
        candidate("ripple-force-wave", RippleForce(number=push.number, coordinate=0),
                  (("cosine", -5 * force, 5 * force, 0.02 * force),
                   ("sine", -5 * force, 5 * force, 0.02 * force),
                   number_field(pushes, travel)),
                  pushes, ("position",)),
    ]  # fmt: skip
    # The best of many wavelengths.
    return [replace(one, least=LEAST_FURTHER, again=AGAIN * once) for one in made]


def number_field(starts: Sequence[tuple[float, ...]], travel: float) -> Field:
    """The field of a wave's number, between half the least and twice the largest of the starts."""
    numbers = [start[-1] for start in starts]
    return "number", 0.5 * min(numbers), 2.0 * max(numbers), 0.1 / travel
