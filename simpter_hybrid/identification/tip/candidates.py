"""The library for a device with several clutches: every effect on all clutches or joints."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from itertools import chain

import numpy as np

from ...effect import Effect
from ...effects.added_inertia import AddedInertia
from ...effects.asymmetry import Asymmetry
from ...effects.bias_force import BiasForce
from ...effects.degressive_speed import DegressiveSpeed
from ...effects.drift import Drift
from ...effects.dry_drag import DryDrag
from ...effects.dwell_breakaway import DwellBreakaway
from ...effects.imbalance import Imbalance
from ...effects.logarithmic_speed import LogarithmicSpeed
from ...effects.position_friction import PositionFriction
from ...effects.quadratic_drag import QuadraticDrag
from ...effects.spring_force import SpringForce
from ...effects.stribeck import Stribeck
from ...effects.thermal_fade import ThermalFade
from ...effects.viscous_drag import ViscousDrag
from ...effects.warm_up import WarmUp
from ...effects.wear_in import WearIn
from ..fitting.predictor import Parameter
from ..rigs.candidate import FURTHER_WAVES
from ..rigs.declared_off import AT_A_LIMIT, TORQUE_SCALE
from ..rigs.effect_candidate import EffectCandidate
from .actuator_effects import ACTUATOR_EFFECTS
from .between import between_clutches
from .made import made, of_clutches
from .ways import Ways, along_lengths, unit_ways

#: (field, lower, upper, typical, start) of a parameter to fit ...
Field = tuple[str, float, float, float, float]
#: ... and of one that shapes the effect: with values from each of which a fit begins.
Shape = tuple[str, float, float, float, tuple[float, ...]]
#: Coordinates on which a residual may depend, by what the effect acts on.
SPEED = ("speed", "slip_velocity", "direction")
FRICTION = ("torque", "excitation", "heat", "distance", "time", *SPEED)
#: Least and most stiffness of a spring along a length, in forces over the way: as of one axis.
OF_LENGTHS = (-2.0, 20.0)


def tip_candidates(
    n: int, m: int, inertia: Sequence[float], force: float, speed: float, tilt: str = "tilt",
    pose: Sequence[float] = (), ways: Ways | None = None,
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
    ways : Ways, optional
        Those of the record; if not given, of angles that go far.

    Returns
    -------
    tuple of EffectCandidate
        Those "by clutch" or "by joint" belong to the same family as the common one.
    """
    ways = unit_ways((False,) * n, m, force, speed) if ways is None else ways
    clutch = [_on_clutches(m, n, *entry) for entry in clutch_effects(ways)]
    own = [joint_effects((inertia[j],) if ways.mixed else inertia, ways, j, tilt) for j in range(n)]
    joint = [_on_joints(rows, ways) for rows in zip(*own, strict=True)]
    further = [
        replace(c, further=True) for e in further_waves(ways) for c in _on_clutches(m, n, *e)
    ]
    found = (*chain.from_iterable((*joint, *clutch)), *further, *between_clutches(m, n))
    found = tuple(_of_kinds(found, ways.lengths, tilt))
    if not len(pose):
        return found
    return tuple(_springs(c, pose, ways) if c.name == "spring-force" else c for c in found)


def clutch_effects(ways: Ways):
    """(name, class, sizes, shared fields, coordinates, ...) of clutch effects."""
    share: Field = ("share", -0.5, 0.5, 0.01, 0.0)
    way, v, slow = np.min(ways.slipped, axis=0).tolist()
    far, fast, _ = np.max(ways.slipped, axis=0).tolist()

    def each(column: int, *parts: float) -> tuple[float, ...]:
        return tuple(part * kind[column] for kind in ways.slipped for part in parts)

    fade, energy, warms = _by_heat(ways.work)
    logarithmic = along_lengths(LogarithmicSpeed, ways, scale=lambda _, speed: 0.03 * speed)
    by_place = along_lengths(PositionFriction, ways, turn=lambda slip, _: slip)
    dwelling = along_lengths(DwellBreakaway, ways, distance=lambda slip, _: 0.01 * slip)
    return (
        ("stribeck", Stribeck, (("rise", -0.8, 1.5, 0.02, 0.02),),
         (("fade", slow, 2 * fast, 0.03 * v, each(1, 0.05, 0.2)),), SPEED),
        ("logarithmic-speed", logarithmic, (("rise", -0.4, 0.6, 0.01, 0.0),), (),
         SPEED),
        ("degressive-speed", DegressiveSpeed, (("rise", -0.8, 2.0, 0.02, 0.02),),
         (("scale", slow, 5 * fast, 0.1 * v, each(1, 0.3)),), SPEED),
        ("asymmetry", Asymmetry, (share,), (), SPEED),
        ("position-friction", by_place, _waves("once"), (), ("position", "torque")),
        ("position-friction-2", by_place, _waves("once", "often"), (),
         ("position", "torque"), "position-friction"),
        ("thermal-fade", fade, (("fade", -0.8, warms, 0.03, 0.02),),
         (("cooling", 0.5, 100.0, 1.0, (2.0, 10.0)),), ("heat", "time", "torque")),
        ("wear-in", WearIn, (("change", -0.8, 1.0, 0.02, 0.02),),
         (("scale", 0.05 * way, 30.0 * far, 0.2 * way, each(0, 0.3, 2.0)),),
         ("distance", "time", "torque")),
        ("warm-up", WarmUp, (("change", -0.8, 1.0, 0.02, 0.02),),
         (energy,), ("distance", "heat", "time")),
        ("drift", Drift, (("rate_per_time", -0.1, 0.2, 0.005, 0.0),), (), ("time", "torque")),
        *ACTUATOR_EFFECTS,
        ("dwell-breakaway", dwelling, (("rise", 0.0, 0.5, 0.02, 0.02),), (), FRICTION),
    )  # fmt: skip


def _by_heat(work: float):
    """`ThermalFade`, energies of a warm-up, and the most that friction fades.

    By a `work` of the record [J]; by a robot's, of which 32 N m act over a radian, if that is 0.
    """
    if not work:
        return ThermalFade, ("energy", 1.0, 1e3, 3.0, (10.0, 50.0)), 5.0
    begins = (0.2 * work, 2 * work, 20 * work)
    energy = ("energy", 0.01 * work, 1e3 * work, 0.03 * work, begins)
    return partial(ThermalFade, energy=10 * work), energy, 200.0


def further_waves(ways: Ways):
    """Rows as of `clutch_effects`: friction that repeats once and three or four times a turn."""
    where = ("position", "torque"), "position-friction"
    for n in FURTHER_WAVES:
        one = partial(PositionFriction, number=float(n))
        wave = along_lengths(one, ways, turn=lambda slip, _: slip)
        yield f"position-friction-{n}", wave, _waves("once", "often"), (), *where


def joint_effects(inertia: Sequence[float], ways: Ways, j: int, tilt: str):
    """(name, class, fields with the sizes of a joint, coordinates) of joint effects."""
    mean = sum(inertia) / len(inertia)
    f, v = ways.forces[j], ways.speeds[j]
    low, high, pulled = _stiffness(ways, j)
    drag = partial(DryDrag, width=0.01 * v) if ways.lengths[j] else DryDrag
    where = ("position", "time")
    return (
        ("viscous-drag", ViscousDrag, (("coefficient", -f / v, 2 * f / v, 0.003 * f / v, 0.0),),
         SPEED),
        ("quadratic-drag", QuadraticDrag,
         (("coefficient", -f / v**2, 2 * f / v**2, 0.003 * f / v**2, 0.0),), SPEED),
        ("dry-drag", drag, (("level", 0.0, f, 0.003 * f, 0.003 * f),), SPEED),
        ("bias-force", BiasForce, (("bias", -f, f, 0.003 * f, 0.0),),
         (*where, "direction")),
        (tilt, Imbalance, (("cosine", -f, f, 0.003 * f, 0.0), ("sine", -f, f, 0.003 * f, 0.0)),
         where),
        ("spring-force", SpringForce, (("stiffness", low, high, pulled, 0.0),),
         where),
        ("added-inertia", AddedInertia,
         (("inertia_change", -0.4 * mean, mean, 0.002 * mean, 0.0),),
         ("acceleration",)),
    )  # fmt: skip


def _stiffness(ways: Ways, j: int) -> tuple[float, float, float]:
    """Least and most stiffness of a joint, and a typical one: the joint's force over its way."""
    stiff = ways.forces[j] / ways.joints[j]
    low, high = OF_LENGTHS if ways.lengths[j] else (-1.0, 1.0)
    return low * stiff, high * stiff, 0.003 * stiff


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


def _on_joints(rows: Sequence[tuple], ways: Ways):
    """Candidates of one kind of effect, of which every joint has a row of `joint_effects`."""
    name, _, fields, coordinates = rows[0]
    n = len(rows)
    effects = tuple(row[1](coordinate=j) for j, row in enumerate(rows))
    where = tuple(f"joint_{j + 1}:{c}" for j in range(n) for c in coordinates)
    if name in ("viscous-drag", "quadratic-drag", "dry-drag"):
        yield made(name, fields, effects, where)
        name = f"{name} by joint"
    each = tuple((f"{j + 1}.{f[0]}", *f[1:]) for j, row in enumerate(rows) for f in row[2])
    yield made(name, each, effects, where)


def _of_kinds(
    found: Sequence[EffectCandidate], lengths: Sequence[bool], tilt: str
) -> Iterator[EffectCandidate]:
    """Those that coordinates of these kinds may have."""
    angles = [str(j + 1) for j, is_length in enumerate(lengths) if not is_length]
    # Newtons and newton metres: no common size.
    common = {c.plain for c in found if c.acts_on == "load" and c.plain} & {c.name for c in found}
    common = common if len(set(lengths)) > 1 else set()
    for c in found:
        if c.name == tilt and len(angles) < len(lengths):
            if angles:  # a weight is no sine of a length
                yield c.only(angles)
        elif c.name not in common:
            yield replace(c, plain="") if c.plain in common else c


def _springs(fixed: EffectCandidate, pose: Sequence[float], ways: Ways) -> EffectCandidate:
    """Springs of unknown rest: one that pulls to angle 0 is more of a constant force."""
    effects = tuple(SpringForce(coordinate=j, rest=float(q)) for j, q in enumerate(pose))
    own: list[Parameter] = []
    for j, q in enumerate(pose):
        name, way = f"spring-force.{j + 1}", ways.joints[j]
        # A cable's, or a counterweight's, may rest far beyond the way; no angle is farther off.
        far = 20.0 * way if ways.lengths[j] else 2.0
        own.append(Parameter(f"{name}.stiffness", 0.0, *_stiffness(ways, j)))
        own.append(Parameter(f"{name}.rest", float(q), q - far, q + far, 0.05 * way))
    stiff = [f / way for f, way in zip(ways.forces, ways.joints, strict=True)]
    starts = tuple(
        tuple(x for j, q in enumerate(pose) for x in (k * stiff[j], float(q)))
        for k in (0.02, -0.02)
    )
    sizes = tuple(p.name for p in own if p.name.endswith("stiffness"))
    return replace(
        fixed, parameters=tuple(own), starts=starts, effect=effects[0], more=effects[1:],
        sizes=sizes, contains=("bias-force",),
    )  # fmt: skip
