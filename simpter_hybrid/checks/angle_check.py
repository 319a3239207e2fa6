"""Whether what goes by a slip angle acts where there is one: where the clutch map is constant."""

from __future__ import annotations

from ..device import Device
from ..part import Part, arguments_of
from ..problems import Problems
from ..scenario import Scenario
from .start_check import clutch_path

#: How far coordinates are moved to see whether a row of the clutch map changes [rad or m] ...
MOVED = 1e-3
#: ... and by which part of its largest entry it then does.
CHANGED = 1e-9


def goes_by_angle(part: Part) -> bool:
    """Whether a map or an effect on a clutch asks for the signal ``angle``."""
    own = part.parameters()
    return "angle" not in own and any("angle" in arguments_of(f) for f in part.functions().values())


def changing_rows(device: Device, q: tuple[float, ...]) -> tuple[int, ...]:
    """Clutches (from 0) whose row of the clutch map changes with the pose.

    Parameters
    ----------
    device : Device
    q : tuple of float, (n,)
        Coordinates around which it is looked at [rad or m].
    """
    n, m = device.n, device.m
    if device.constant_clutch_map or len(q) != n:
        return ()
    # Each by another amount: together they might leave a difference of two as it is.
    ways = [MOVED / (j + 1) for j in range(n)]
    poses = [[x + sign * way for x, way in zip(q, ways, strict=True)] for sign in (0.0, 1.0, -1.0)]
    numbers, maps = [*device.parameters().values(), *device.table()], []
    for pose in poses:
        maps.append(out := [0.0] * (m * n))
        try:
            device.functions()["clutch_map"](pose, numbers, out)
        except Exception:  # told where the device is checked
            return ()
    first, *others = maps
    largest = max(map(abs, first), default=0.0)
    return tuple(
        i for i in range(m)
        if any(abs(other[k] - first[k]) > CHANGED * largest
               for other in others for k in range(i * n, (i + 1) * n))
    )  # fmt: skip


def check_angles(s: Scenario, problems: Problems) -> None:
    """Record maps and effects that go by the slip angle of a clutch that has none."""
    asking = [
        *((("effects", k), e, e.clutch) for k, e in enumerate(s.effects) if e.clutch >= 0),
        *(((*clutch_path(problems, i), "torque"), c.torque, i) for i, c in enumerate(s.clutches)),
    ]
    asking = [each for each in asking if goes_by_angle(each[1])]
    changing = changing_rows(s.device, s.q) if asking else ()
    steady = [name for i, name in enumerate(s.device.surfaces) if i not in changing]
    for path, part, i in asking:
        if i in changing:
            problems.add(
                path,
                "it goes by the slip angle C q, which is no slip where the clutch map C changes",
                f"{type(part).__name__} on clutch {i + 1} ({s.device.surfaces[i]})",
                f"a clutch whose row of C is constant ({', '.join(steady) or 'here none'}), "
                "or an effect or map that goes by something else",
            )
