"""The library for a device with several clutches: every effect on all clutches or joints."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from itertools import chain

from ...effect import Effect
from ...effects.added_inertia import AddedInertia
from ...effects.asymmetry import Asymmetry
from ...effects.bias_force import BiasForce
from ...effects.command_scale import CommandScale
from ...effects.degressive_speed import DegressiveSpeed
from ...effects.drift import Drift
from ...effects.dry_drag import DryDrag
from ...effects.dwell_breakaway import DwellBreakaway
from ...effects.imbalance import Imbalance
from ...effects.logarithmic_speed import LogarithmicSpeed
from ...effects.other_commands import OtherCommands
from ...effects.other_excitations import OtherExcitations
from ...effects.play_hysteresis import PlayHysteresis
from ...effects.position_friction import PositionFriction
from ...effects.pull_in import PullIn
from ...effects.quadratic_drag import QuadraticDrag
from ...effects.release_asymmetry import ReleaseAsymmetry
from ...effects.remanence import Remanence
from ...effects.second_lag import SecondLag
from ...effects.slew_limit import SlewLimit
from ...effects.spring_force import SpringForce
from ...effects.stribeck import Stribeck
from ...effects.thermal_fade import ThermalFade
from ...effects.torque_lag import TorqueLag
from ...effects.viscous_drag import ViscousDrag
from ...effects.warm_up import WarmUp
from ...effects.wear_in import WearIn
from ..fitting.predictor import Parameter
from ..rigs.candidate import FURTHER_WAVES
from ..rigs.declared_off import AT_A_LIMIT, TORQUE_SCALE
from ..rigs.effect_candidate import EffectCandidate
from .between import between_clutches
from .made import SWITCHING, made, of_clutches

#: (field, lower, upper, typical, start) of a parameter to fit ...
Field = tuple[str, float, float, float, float]
#: ... and of one that shapes the effect: with values from each of which a fit begins.
Shape = tuple[str, float, float, float, tuple[float, ...]]
#: Coordinates on which a residual may depend, by what the effect acts on.
SPEED = ("speed", "slip_velocity", "direction")
FRICTION = ("torque", "excitation", "heat", "distance", "time", *SPEED)


def tip_candidates(
    n: int, m: int, inertia: Sequence[float], force: float, speed: float, tilt: str = "tilt",
    pose: Sequence[float] = (),
):  # fmt: skip
    """Every effect on all clutches or all joints alike, and with a size for each of them.

    Parameters
    ----------
    n, m : int
        Coordinates and clutches.
    inertia : sequence of float
        Declared inertia of every coordinate [kg m^2].
    force, speed : float
        Typical generalized force and largest speed in the record [SI].
    tilt : str
        Name of a weight on every joint.
    pose : sequence of float, optional
        Pose in the middle of the record: springs are given a rest, looked for from there on.

    Returns
    -------
    tuple of EffectCandidate
        Those "by clutch" or "by joint" belong to the same family as the common one.
    """
    clutch = [_on_clutches(m, n, *entry) for entry in clutch_effects(speed)]
    joint = [_on_joints(n, *entry) for entry in joint_effects(inertia, force, speed, tilt)]
    further = [replace(c, further=True) for e in further_waves() for c in _on_clutches(m, n, *e)]
    found = (*chain.from_iterable((*joint, *clutch)), *further, *between_clutches(m, n))
    if not len(pose):
        return found
    return tuple(_springs(c, pose, force) if c.name == "spring-force" else c for c in found)


def clutch_effects(v: float):
    """(name, class, sizes, shared fields, coordinates, ...) of clutch effects."""
    share: Field = ("share", -0.5, 0.5, 0.01, 0.0)
    return (
        ("stribeck", Stribeck, (("rise", -0.8, 1.5, 0.02, 0.02),),
         (("fade", 0.01, 2 * v, 0.03 * v, (0.05 * v, 0.2 * v)),), SPEED),
        ("logarithmic-speed", LogarithmicSpeed, (("rise", -0.4, 0.6, 0.01, 0.0),), (),
         SPEED),
        ("degressive-speed", DegressiveSpeed, (("rise", -0.8, 2.0, 0.02, 0.02),),
         (("scale", 0.01, 5 * v, 0.1 * v, (0.3 * v,)),), SPEED),
        ("asymmetry", Asymmetry, (share,), (), SPEED),
        ("position-friction", PositionFriction, _waves("once"), (), ("position", "torque")),
        ("position-friction-2", PositionFriction, _waves("once", "often"), (),
         ("position", "torque"), "position-friction"),
        ("thermal-fade", ThermalFade, (("fade", -0.8, 5.0, 0.03, 0.02),),
         (("cooling", 0.5, 100.0, 1.0, (2.0, 10.0)),), ("heat", "time", "torque")),
        ("wear-in", WearIn, (("change", -0.8, 1.0, 0.02, 0.02),),
         (("scale", 0.05, 30.0, 0.2, (0.3, 2.0)),), ("distance", "time", "torque")),
        ("warm-up", WarmUp, (("change", -0.8, 1.0, 0.02, 0.02),),
         (("energy", 1.0, 1e3, 3.0, (10.0, 50.0)),), ("distance", "heat", "time")),
        ("drift", Drift, (("rate_per_time", -0.1, 0.2, 0.005, 0.0),), (), ("time", "torque")),
        # Begun inside the loop: one beside the declared map shifts all torque scales at once.
        ("play-hysteresis", PlayHysteresis, (("share", 0.0, 1.0, 0.02, 0.15),),
         (("width", 0.1, 8.0, 0.2, (0.7, 2.5)), ("lift", 0.0, 2.0, 0.1, (0.7,))),
         SWITCHING),
        ("remanence", Remanence, (("width", 0.0, 2.0, 0.02, 0.03),), (), SWITCHING),
        ("slew-limit", SlewLimit, (("slowness", 0.0, 0.2, 0.002, 0.012),
                                   ("slowness_down", 0.0, 0.2, 0.002, 0.012)), (),
         SWITCHING),
        ("release-asymmetry", ReleaseAsymmetry, (("share", -0.8, 3.0, 0.03, 0.0),), (),
         SWITCHING),
        ("torque-lag", TorqueLag, (("share", 0.0, 1.0, 0.03, 0.05),), (), SWITCHING),
        ("second-lag", SecondLag, (("lag", 1e-4, 0.1, 0.002, 0.003),), (), SWITCHING),
        ("pull-in", PullIn, (("extra", -0.02, 0.1, 0.003, 0.003),
                             ("drop_out", 0.0, 1.0, 0.02, 0.0)), (),
         SWITCHING),
        ("other-commands", OtherCommands, (("gain", -0.5, 0.5, 0.01, 0.0),
                                           ("relative", -0.1, 0.1, 0.002, 0.0)), (),
         SWITCHING),
        ("other-excitations", OtherExcitations, (("gain", -0.5, 0.5, 0.01, 0.0),
                                                 ("relative", -0.1, 0.1, 0.002, 0.0)), (),
         SWITCHING),
        ("command-scale", CommandScale, (("gain", -0.5, 0.5, 0.01, 0.0),
                                         ("offset", -2.0, 2.0, 0.01, 0.0)), (),
         SWITCHING),
        ("dwell-breakaway", DwellBreakaway, (("rise", 0.0, 0.5, 0.02, 0.02),), (), FRICTION),
    )  # fmt: skip


def further_waves():
    """Rows as of `clutch_effects`: friction that repeats once and three or four times a turn."""
    where = ("position", "torque"), "position-friction"
    for n in FURTHER_WAVES:
        wave = partial(PositionFriction, number=float(n))
        yield f"position-friction-{n}", wave, _waves("once", "often"), (), *where


def joint_effects(inertia: Sequence[float], f: float, v: float, tilt: str):
    """(name, class, fields with a size for each joint, coordinates) of joint effects."""
    mean = sum(inertia) / len(inertia)
    where = ("position", "time")
    return (
        ("viscous-drag", ViscousDrag, (("coefficient", -f / v, 2 * f / v, 0.003 * f / v, 0.0),),
         SPEED),
        ("quadratic-drag", QuadraticDrag,
         (("coefficient", -f / v**2, 2 * f / v**2, 0.003 * f / v**2, 0.0),), SPEED),
        ("dry-drag", DryDrag, (("level", 0.0, f, 0.003 * f, 0.003 * f),), SPEED),
        ("bias-force", BiasForce, (("bias", -f, f, 0.003 * f, 0.0),),
         (*where, "direction")),
        (tilt, Imbalance, (("cosine", -f, f, 0.003 * f, 0.0), ("sine", -f, f, 0.003 * f, 0.0)),
         where),
        ("spring-force", SpringForce, (("stiffness", -f, f, 0.003 * f, 0.0),),
         where),
        ("added-inertia", AddedInertia,
         (("inertia_change", -0.4 * mean, mean, 0.002 * mean, 0.0),),
         ("acceleration",)),
    )  # fmt: skip


def _on_clutches(
    m: int, n: int, name: str, cls: Callable[..., Effect], sizes: tuple[Field, ...],
    shared: tuple[Shape, ...], coordinates: tuple[str, ...],
    simpler: str = "",
):  # fmt: skip
    effects = tuple(cls(clutch=i) for i in range(m))
    where = of_clutches(m, n, coordinates)
    one = made(name, (*sizes, *shared), effects, where)
    fields = tuple((f"{i + 1}.{s[0]}", *s[1:]) for i in range(m) for s in sizes)
    name = f"{name} by clutch"
    own = made(name, (*fields, *shared), effects, where)
    scales = (TORQUE_SCALE,) if one.family in AT_A_LIMIT else ()
    yield replace(one, simpler=simpler, contains=scales)
    each = tuple(f"{scale} by clutch" for scale in scales)
    yield replace(own, simpler=simpler and f"{simpler} by clutch", contains=(*scales, *each))


def _waves(*numbers: str) -> tuple[Field, ...]:
    """Amplitudes of both phases; every clutch has its own phase where it has its own size."""
    return tuple((f"{n}_{part}", -0.5, 0.5, 0.01, 0.0) for n in numbers for part in ("cos", "sin"))


def _on_joints(n: int, name: str, cls: type[Effect], fields, coordinates):
    effects = tuple(cls(coordinate=j) for j in range(n))
    where = tuple(f"joint_{j + 1}:{c}" for j in range(n) for c in coordinates)
    if name in ("viscous-drag", "quadratic-drag", "dry-drag"):
        yield made(name, fields, effects, where)
        name = f"{name} by joint"
    each = tuple((f"{j + 1}.{f[0]}", *f[1:]) for j in range(n) for f in fields)
    yield made(name, each, effects, where)


def _springs(fixed: EffectCandidate, pose: Sequence[float], f: float) -> EffectCandidate:
    """Springs of unknown rest: one that pulls to angle 0 is more of a constant force."""
    effects = tuple(SpringForce(coordinate=j, rest=float(q)) for j, q in enumerate(pose))
    own: list[Parameter] = []
    for j, q in enumerate(pose):
        name = f"spring-force.{j + 1}"
        own.append(Parameter(f"{name}.stiffness", 0.0, -f, f, 0.003 * f))
        own.append(Parameter(f"{name}.rest", float(q), q - 2.0, q + 2.0, 0.05))
    starts = tuple(tuple(x for q in pose for x in (k * f, float(q))) for k in (0.02, -0.02))
    sizes = tuple(p.name for p in own if p.name.endswith("stiffness"))
    return replace(
        fixed, parameters=tuple(own), starts=starts, effect=effects[0], more=effects[1:],
        sizes=sizes, contains=("bias-force",),
    )  # fmt: skip
