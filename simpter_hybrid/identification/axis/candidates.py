"""Effects that are tried on one driven axis, with sizes taken from the recorded motion."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType

from ...laws.axis_friction import CoulombViscous
from ...scenario import Scenario
from ..fitting.predictor import Parameter
from ..rigs.declared_off import TORQUE_SCALE, scaled_numbers, with_scale
from ..rigs.effect_candidate import EffectCandidate
from ..tracing.named import coordinate_of
from .force_candidates import drags, of_ends, of_load, of_place, of_turns, of_weight
from .friction_candidates import (
    after_rest,
    falling_and_rising,
    giving_way,
    in_time,
    of_speed,
    with_heat,
)
from .position_waves import Wave
from .sizes import AxisSizes
from .wave_candidates import any_wave

#: The name of dry friction off its declared size, where no clutch is switched.
FRICTION_SCALE = "friction-scale"
#: ... and of dry friction where none is declared, of which no factor makes any.
DRY_FRICTION = "dry-friction"
#: Effect -> the experiment that tells it from others, where no motion of the axis does.
OTHERWISE = {
    "added-inertia": "The same runs with a known mass added.",
    "asymmetry": "The same runs with the friction pressed more, or less.",
    "asymmetry-level": "The same runs with the axis turned round.",
    "bias-force": "The same runs with the axis turned round.",
}
#: Words about clutches that are left out of the text of an experiment with an axis.
NO_CLUTCH = (", with all clutches off", " with all clutches off", " with clutches off",
             ", at constant excitation", " at constant excitation", ", at several excitations",
             " and excitation")  # fmt: skip
#: Words for an axis that turns, and those that stand in their place for one that slides.
SLIDES = {"Spin up to": "Go up to", "Spin at": "Move at", "Slow turns": "Slow strokes",
          "slow turns": "slow strokes"}  # fmt: skip


def axis_candidates(
    sizes: AxisSizes,
    waves: Sequence[tuple[Wave, Wave]] = (),
    spring: tuple[tuple[float, float], ...] = (),
    met: Mapping[float, tuple[float, float] | None] = MappingProxyType({}),
    pulled: bool = False,
) -> tuple[EffectCandidate, ...]:
    """The library for one axis.

    Parameters
    ----------
    sizes : AxisSizes
    waves : sequence of (Wave, Wave)
        Of friction and of a force, that recorded motions show best.
    spring : tuple of (float, float)
        Stiffness and rest from which a spring is looked for as well.
    met : mapping of float to (float, float)
        Side (1 above, -1 below) -> stiffness over inertia [1/s^2] and place [rad or m] at which a
        spring at that end is met, where one was seen.
    pulled : bool
        Whether the model has a weight or a spring, with which a bearing's friction may grow.
    """
    found = (
        *of_speed(sizes),
        *giving_way(sizes),
        *after_rest(sizes),
        *in_time(sizes),
        *drags(sizes),
        *of_place(sizes, spring),
        *of_load(sizes),
        *((of_weight(),) if pulled else ()),
        *with_heat(sizes),
        *falling_and_rising(sizes),
        *of_ends(sizes, met),
        *(of_turns(sizes) if sizes.turning else ()),
        *(any_wave(waves, sizes.force, sizes.inertia, sizes.travel) if waves else ()),
    )
    turns = sizes.turning
    return tuple(
        replace(of_one_balance(e), experiment=OTHERWISE.get(e.name, of_axis(e.experiment, turns)))
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
    library: Sequence[EffectCandidate], declared: Scenario, force: float
) -> tuple[EffectCandidate, ...]:
    """The library, and dry friction that is off what was declared by more than its tolerance.

    Where none is declared it is looked for up to twice `force` [N or N m].
    """
    where, test = ("force:direction", "force:slip_velocity"), "A slow sweep both ways."
    scaled = with_scale(library, declared, FRICTION_SCALE, 10.0, where, test)
    laws = [clutch.torque for clutch in declared.clutches]
    bare = [k for k, law in enumerate(laws, 1) if isinstance(law, CoulombViscous)]
    if not bare or scaled_numbers(declared, *range(len(laws))):
        return scaled
    turning = "length" not in declared.device.coordinate_dimensions
    own = f"{DRY_FRICTION}.level"
    level = Parameter(own, 0.0, 0.0, 2.0 * force, 0.02 * force, unit="N m" if turning else "N")
    dry = EffectCandidate(
        DRY_FRICTION, (level,), ((0.1 * force,), (0.5 * force,)), TORQUE_SCALE, "friction", where,
        test, sizes=(own,), shifts=((own, f"clutch.{bare[0]}.torque.coulomb", 1.0),),
    )  # fmt: skip
    # On runs that go one way alone, friction of one direction does what that of both does.
    one_way = (
        replace(c, contains=(*c.contains, DRY_FRICTION), yields_to=DRY_FRICTION)
        if c.name == "asymmetry-level"
        else c
        for c in scaled
    )
    return (*one_way, dry)


def of_one_balance(one: EffectCandidate) -> EffectCandidate:
    """A candidate whose coordinates are all of the one balance ``force``.

    For axes, where friction and load show in the same place.
    """
    return replace(one, coordinates=tuple(f"force:{coordinate_of(n)}" for n in one.coordinates))
