"""How far joints and clutches went in a record: from this come the sizes of what acts by place."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from ...effect import Effect
from ...scenario import Scenario
from ..fitting.replay import Replay
from ..rigs.pose import clutch_maps, slip_travels

#: An angle that goes farther [rad] has the sizes of a whole radian: so had a robot's, which go 0.4
#: to 1.2, when these sizes were measured.
WIDE = 0.35
#: What hardly moves has this part of the farthest way [m or rad]: no force is over no way.
LEAST = 0.01
#: A slow speed of an angle [rad/s], and the part of the largest that is one of a length.
SLOW = 0.01


class Ways(NamedTuple):
    """Ways, forces and speeds of a record, of every joint and of every clutch.

    Attributes
    ----------
    lengths : tuple of bool
        Whether each coordinate is one.
    joints : tuple of float
        Over which the force of a spring changes [rad or m]; a radian of an angle that goes far.
    slips : tuple of float
        How far each clutch slipped that rubs along a length [m]; 0 of the others.
    forces, speeds : tuple of float
        Of each joint [SI]; the largest of all where all are of one kind.
    """

    lengths: tuple[bool, ...]
    joints: tuple[float, ...]
    slips: tuple[float, ...]
    forces: tuple[float, ...]
    speeds: tuple[float, ...]

    @property
    def mixed(self) -> bool:
        """Whether some coordinates are lengths and others angles: no size is common to them."""
        return len(set(self.lengths)) > 1

    @property
    def small(self) -> bool:
        """Whether some coordinate is no angle that goes far: what is far off 0 there differs."""
        return any(self.lengths) or min(self.joints) < 1.0

    @property
    def slipped(self) -> tuple[tuple[float, float, float], ...]:
        """Way, speed, and a speed that is slow, of each kind of clutches: over angles, lengths."""
        found = []
        if not all(self.slips):
            found.append((1.0, self._fastest(False), SLOW))
        if any(self.slips):
            found.append((max(self.slips), self.sliding, SLOW * self.sliding))
        return tuple(found)

    @property
    def sliding(self) -> float:
        """Largest speed of a coordinate that is a length [m/s]."""
        return self._fastest(True)

    @property
    def work(self) -> float:
        """What the largest force does over a way [J]; 0 where a robot's numbers hold.

        These are for some N m over about a radian: a joule and more.
        """
        most = max(f * way for f, way in zip(self.forces, self.joints, strict=True))
        return most if any(self.lengths) or most < 1.0 else 0.0

    def _fastest(self, lengths: bool) -> float:
        known = zip(self.speeds, self.lengths, strict=True)
        return max([v for v, is_length in known if is_length == lengths] or self.speeds)


def unit_ways(lengths: Sequence[bool], m: int, force: float, speed: float) -> Ways:
    """Ways of a radian, or a metre, of coordinates of these kinds, and of `m` clutches."""
    n = len(lengths)
    return Ways(tuple(lengths), (1.0,) * n, (0.0,) * m, (force,) * n, (speed,) * n)


def along(declared: Scenario) -> tuple[bool, ...]:
    """Whether each coordinate of a model is a length."""
    kinds = declared.device.coordinate_dimensions or ("angle",) * declared.device.n
    return tuple(kind == "length" for kind in kinds)


def ways_of(
    declared: Scenario,
    replays: Sequence[Replay],
    inertia: Sequence[float],
    force: float,
    speed: float,
    drives: Sequence[float] = (),
) -> Ways:
    """Ways of the fitted runs, whose notes have positions and speeds of all joints in rows.

    Parameters
    ----------
    declared : Scenario
    replays : sequence of Replay
    inertia : sequence of float
        Declared inertia of every coordinate [kg m^2 or kg].
    force, speed : float
        Typical force and largest speed of all joints [SI].
    drives : sequence of float, optional
        Largest force of each joint's drive [N m or N].
    """
    n, lengths = declared.device.n, along(declared)
    places = np.hstack([r.notes["position"] for r in replays])
    went = _none_far_below(np.ptp(places, axis=1))
    joints = [
        way if is_length or way < WIDE else 1.0
        for way, is_length in zip(went, lengths, strict=True)
    ]
    ends = [
        slip_travels(declared, r.time, r.notes["position"].T, r.notes["speed"].T) for r in replays
    ]
    rows = clutch_maps(declared, places[:, :1].T)[0]
    straight = np.array(lengths)
    rubs = tuple(row[straight].any() and not row[~straight].any() for row in rows)
    slips = _none_far_below(np.max(ends, axis=0))
    made = Ways(
        lengths, tuple(joints), tuple(s if r else 0.0 for s, r in zip(slips, rubs, strict=True)),
        (force,) * n, (speed,) * n,
    )  # fmt: skip
    if not made.mixed:
        return made
    # What nothing drives is moved by the others: a pole on a cart.
    moved = zip(drives or (0.0,) * n, inertia, _most(replays, _accelerations, 0.9), strict=True)
    speeds = _most(replays, lambda replay: replay.notes["speed"], 0.99)
    return made._replace(  # what stands still all the time has the usual sizes
        forces=tuple(max(drive, i * bent) or force for drive, i, bent in moved),
        speeds=tuple(fastest or speed for fastest in speeds),
    )


def _accelerations(replay: Replay) -> np.ndarray:
    """Of all joints in every row (n, samples) [rad/s^2 or m/s^2]."""
    return np.gradient(replay.notes["speed"], replay.time, axis=1)


def _most(
    replays: Sequence[Replay], told: Callable[[Replay], np.ndarray], part: float
) -> tuple[float, ...]:
    """Largest magnitude of what is told of every joint, but for a part of a run's rows."""
    each = [np.quantile(np.abs(told(replay)), part, axis=1) for replay in replays]
    return tuple(np.max(each, axis=0).tolist())


def _none_far_below(ways: np.ndarray) -> list[float]:
    """Ways, none far below the farthest."""
    return np.maximum(ways, LEAST * ways.max(initial=0.0)).tolist()


def along_lengths(
    cls: Callable[..., Effect], ways: Ways, **sizes: Callable[[float, float], float]
) -> Callable[..., Effect]:
    """An effect on a clutch, with fields by the clutch's way and speed if it rubs along a length.

    Parameters
    ----------
    cls : callable
        Makes the effect on a clutch.
    ways : Ways
    **sizes : callable
        Field -> its value by way [m] and speed [m/s].
    """

    def made(clutch: int) -> Effect:
        way = ways.slips[clutch]
        fields = {name: of(way, ways.sliding) for name, of in sizes.items()} if way else {}
        return cls(clutch=clutch, **fields)

    return made
