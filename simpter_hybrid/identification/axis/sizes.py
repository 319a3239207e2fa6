"""Sizes of a recorded motion, from which candidates of an axis are made."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from ...effects.spring_force import SpringForce
from ...scenario import Scenario
from ..fitting.replay import Replay
from ..recordings.row_step import row_step
from ..recordings.smoothing import derivative, speed_width
from ..rigs.pose import inertia_of
from .pieces import since_its_beginning
from .position_waves import SLOW

#: Part of the largest speed that is no motion back.
BACK = 0.02
#: A run is in motion from its first so many rows on if these have this part of its largest speed.
FIRST, MOVING = 3, 0.2


class AxisSizes(NamedTuple):
    """Sizes of a recorded motion from which the ranges of effects are taken.

    Attributes
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
    one_way : bool
        Whether it goes beyond a turn and never back: what turns so is held by no spring.
    slides : bool
        Whether every run is in motion from its first row on, never goes back and never starts
        again from rest: it has slid before, and nothing shows how friction gives way.
    """

    speed: float
    force: float
    travel: float
    duration: float
    inertia: float
    turning: bool
    low: float = 0.0
    high: float = 0.0
    one_way: bool = False
    slides: bool = False

    @property
    def middle(self) -> float:
        """Middle of the recorded travel [rad or m]."""
        return 0.5 * (self.low + self.high)

    @property
    def turn(self) -> float:
        """Way after which a place comes again [rad]; inf where less than a turn is passed."""
        return 2 * math.pi if self.turning and self.high - self.low > 2 * math.pi else math.inf


def sizes_of(replays: Sequence[Replay], force: float, inertia: float, turning: bool) -> AxisSizes:
    """Sizes of recorded runs; `force`, `inertia` and `turning` as in `AxisSizes`."""
    speed = max(float(np.quantile(np.abs(r.notes["speed"]), 0.99)) for r in replays)
    travel = max(float(np.ptp(r.notes["position"])) for r in replays)
    lasts = max(map(since_its_beginning, replays))
    made = AxisSizes(speed, force, travel, lasts, inertia, turning, *ends_of(replays))
    forth = max(float(np.max(r.notes["speed"])) for r in replays)
    back = max(float(-np.min(r.notes["speed"])) for r in replays)
    one_way = math.isfinite(made.turn) and min(forth, back) < BACK * speed
    return made._replace(one_way=one_way, slides=all(slides(r.notes["speed"]) for r in replays))


def slides(speed: np.ndarray) -> bool:
    """Whether a run with these speeds (samples,) begins in motion, and goes on until it rests."""
    most = float(np.abs(speed).max())
    back = min(float(speed.max()), float(-speed.min()))
    if back >= BACK * most or abs(float(np.median(speed[:FIRST]))) <= MOVING * most:
        return False
    rests = np.flatnonzero(np.abs(speed) < BACK * most)
    return not rests.size or bool(np.abs(speed[rests[0] :]).max() < MOVING * most)


def size_of_forces(declared: Scenario, replays: Sequence[Replay]) -> float:
    """Force of inertia in the record, or twice the friction if that is more [N or N m]."""
    shaken = max(
        float(np.quantile(np.abs(np.gradient(r.notes["speed"], r.time)), 0.9)) for r in replays
    )
    level = declared.clutches[0].torque.parameters().get("coulomb", 0.0)
    return max(inertia_of(declared) * shaken, 2.0 * level)


def pulls_back(declared: Scenario) -> bool:
    """Whether the model has a weight or a spring, whose force depends on the place."""
    springs = any(isinstance(effect, SpringForce) for effect in declared.effects)
    return bool(declared.device.parameters().get("weight", 0.0)) or springs


def swung(declared: Scenario, replays: Sequence[Replay]) -> tuple[tuple[float, float], ...]:
    """Stiffness and rest of the spring that the swings of runs let alone show; () without one.

    A model without it rests where it is let go, and from there no small stiffness moves it.
    """
    if pulls_back(declared) or any(r.inputs["drive"].any() for r in replays):
        return ()
    rows = []
    for replay in replays:
        step, speed = row_step(replay.time), replay.notes["speed"]
        bent = derivative(speed, step, speed_width(step))
        moving = np.abs(speed) > SLOW * float(np.quantile(np.abs(speed), 0.9))
        told = [replay.notes["position"], np.ones(speed.size), np.sign(speed), bent]
        rows.append(np.column_stack(told)[moving])
    known = np.concatenate(rows)
    slope, level, _ = np.linalg.lstsq(known[:, :3], known[:, 3], rcond=None)[0]
    return ((-inertia_of(declared) * slope, -level / slope),) if slope < 0.0 else ()


def ends_of(replays: Sequence[Replay]) -> tuple[float, float]:
    """Ends of the coordinate in the record."""
    reached = [(r.notes["position"].min(), r.notes["position"].max()) for r in replays]
    return float(min(a for a, _ in reached)), float(max(b for _, b in reached))
