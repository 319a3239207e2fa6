"""The library for two driven joints: that of several clutches, and what their drives do wrong."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

from ...effects.asymmetry import Asymmetry
from ...effects.dahl import Dahl
from ...effects.drive_gain import DriveGain
from ...effects.drive_lag import DriveLag
from ...effects.load_dependent import LoadDependent
from ...scenario import Scenario
from ..fitting.predictor import Parameter
from ..rigs.effect_candidate import EffectCandidate
from .candidates import SPEED, tip_candidates
from .link_weights import are_relative, link_weights, weighs_nothing
from .made import SWITCHING, made, of_clutches
from .structure import time_constants
from .ways import Ways, along, unit_ways

#: Coordinates on which a residual depends where a drive gives more, or comes late.
SCALED, TIMED = ("torque", "acceleration", "direction"), ("slip_velocity", "speed", "acceleration")
#: Shortest lag of a drive that is simulated, and the largest that is looked for [s].
SHORTEST, LONGEST = 5e-4, 0.2
#: Name of weights off the axes.
TILT = "tilt"
#: Of the candidates of several clutches those that two joints show at all.
KEPT = ("friction", "load")


def joint_candidates(
    declared: Scenario,
    inertia: Sequence[float],
    force: float,
    speed: float,
    turned: Sequence[float],
    commanded: Sequence[int],
    travels: Sequence[float],
    pose: Sequence[float] = (),
    ways: Ways | None = None,
) -> tuple[EffectCandidate, ...]:
    """Every effect that is tried on two driven joints.

    Parameters
    ----------
    declared : Scenario
    inertia : sequence of float
        Declared inertia of every coordinate [kg m^2 or kg].
    force, speed : float
        Typical generalized force and largest speed in the record [SI].
    turned : sequence of float
        Force on every joint for each unit of its drive.
    commanded : sequence of int
        Clutches whose commands were recorded: what their actuators lack is asked, and whether they
        hold more after a rest.
    travels : sequence of float
        How far every clutch slipped [rad or m].
    pose : sequence of float, optional
        Pose in the middle of the record, from which on a spring's rest is looked for.
    ways : Ways, optional
        Those of the record; if not given, of a radian or a metre each.
    """
    n, m = declared.device.n, declared.device.m
    ways = unit_ways(along(declared), m, force, speed) if ways is None else ways
    found = tip_candidates(n, m, inertia, force, speed, pose=pose, ways=ways)
    kept = [c for c in found if c.acts_on in KEPT]
    clutches = {str(i + 1) for i in commanded}
    for c in found:
        if not commanded or c.acts_on not in ("actuator", "breakaway"):
            continue
        if not c.places or len(clutches) == m:
            kept.append(c)
        elif own := [place for place in c.places if place in clutches]:
            kept.append(c.only(own))  # and none of pairs of clutches
    if are_relative(declared) and weighs_nothing(declared):
        kept = [link_weights(TILT, force) if c.name == TILT else c for c in kept]
    yielding = _giving_way(n, travels, alike=not ways.mixed)
    beside = (*_of_directions(m, n, force), *yielding, *_of_loads(m, n), *_of_drives(n, turned))
    return (*kept, *beside)


def late_clutches(declared: Scenario, commanded: Sequence[int]) -> Iterator[EffectCandidate]:
    """Lags off their declared ones, of clutches that have one and whose commands were recorded."""
    n, m = declared.device.n, declared.device.m
    lagging = [i for i in commanded if declared.clutches[i].time_constant > 0.0]
    told = (f"joint_{j + 1}:command_{i + 1}" for j in range(n) for i in lagging)
    where = (*of_clutches(m, n, SWITCHING), *told)
    yield from time_constants(declared, lagging, where)


def _of_directions(m: int, n: int, f: float) -> Iterator[EffectCandidate]:
    """Coulomb friction that differs between directions: what is viscous stays."""
    effects = tuple(Asymmetry(clutch=i) for i in range(m))
    fields = tuple((f"{i + 1}.level", -f, f, 0.003 * f, 0.0) for i in range(m))
    yield made("asymmetry-level", fields, effects, of_clutches(m, n, SPEED))


def _giving_way(n: int, travels: Sequence[float], alike: bool) -> Iterator[EffectCandidate]:
    """Friction that gives way before it slips, over one displacement or over each clutch's own.

    Of clutches that slipped: nothing shows how another gives way.
    """
    m = len(travels)
    effects = tuple(Dahl(clutch=i) for i in range(m))
    where = of_clutches(m, n, ("displacement_since_reversal", *SPEED))

    def over(label: str, travel: float):
        starts = (5e-4 * travel, 5e-3 * travel)
        return (f"{label}displacement", 2e-4 * travel, 0.5 * travel, 2e-3 * travel, starts)

    slipped = [i for i, travel in enumerate(travels) if travel > 0.0]
    every = len(slipped) == m
    if alike and every:
        yield made("presliding", (over("", min(travels)),), effects, where)
    plain, each = "presliding" if alike and every else "", []
    for i in slipped:
        # No displacement is none: where it acts on one clutch alone is asked for each.
        name, fields = f"presliding by clutch {i + 1}", (over("", travels[i]),)
        one = made(name, fields, effects[i : i + 1], where)
        each.append(replace(one, plain=plain, at=(f"clutch {i + 1}",)))
    yield from each
    if every and m > 1:
        fields = tuple(over(f"{i + 1}.", travel) for i, travel in enumerate(travels))
        both = made("presliding by clutch", fields, effects, where)
        yield replace(both, plain=plain, contains=tuple(c.name for c in each))


def _of_loads(m: int, n: int) -> Iterator[EffectCandidate]:
    """Friction that grows with what goes through a joint."""
    effects = tuple(LoadDependent(clutch=i) for i in range(m))
    fields = tuple((f"{i + 1}.rise", 0.0, 0.9, 0.01, 0.01) for i in range(m))
    where = of_clutches(m, n, ("torque", "acceleration"))
    yield made("load-dependent", fields, effects, where)


def _of_drives(n: int, turned: Sequence[float]) -> Iterator[EffectCandidate]:
    """Drives that give more than they are told, and those that follow it late."""
    gains = tuple(DriveGain(coordinate=j, constant=turned[j]) for j in range(n))
    where = tuple(f"joint_{j + 1}:{c}" for j in range(n) for c in SCALED)
    fields = tuple((f"{j + 1}.gain", -0.5, 1.0, 0.01, 0.0) for j in range(n))
    yield made("drive-gain", fields, gains, where)
    lags = tuple(DriveLag(coordinate=j, constant=turned[j], lag=SHORTEST) for j in range(n))
    where = tuple(f"joint_{j + 1}:{c}" for j in range(n) for c in TIMED)
    late: Any = [(f"{j + 1}.lag", SHORTEST, LONGEST, 0.002, (SHORTEST, 0.01)) for j in range(n)]
    one = made("drive-lag", late, lags, where)
    # One joint's or both; and the least is none.
    starts = tuple(s for s in one.starts if max(s) > SHORTEST)
    sizes = tuple(p.name for p in one.parameters)
    yield replace(one, starts=starts, sizes=sizes, parameters=tuple(map(_least, one.parameters)))


def _least(p: Parameter) -> Parameter:
    return replace(p, value=SHORTEST)
