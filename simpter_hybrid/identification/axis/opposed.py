"""A drive that is against the motion all along: it brakes, or a sign in the map is wrong."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..fitting.replay import Replay
from ..recordings.checks import Finding

#: Rows count in which drive and speed are more than this part of their largest.
COUNTS = 0.1
#: Against the motion in this part of at least so many rows.
OFTEN, FEWEST = 0.9, 50


def opposed(replays: Sequence[Replay], constant: float) -> tuple[Finding, ...]:
    """A remark, if what drives is against the motion in nearly all rows in which both are there.

    Parameters
    ----------
    replays : sequence of Replay
        Of a driven axis.
    constant : float
        Force for each unit of the recorded drive, whose sign counts.
    """
    drive = np.sign(constant) * np.concatenate([r.inputs["drive"] for r in replays])
    speed = np.concatenate([r.notes["speed"] for r in replays])
    both = (np.abs(x) > COUNTS * np.abs(x).max() for x in (drive, speed))
    rows = np.logical_and(*both)
    against = float(np.mean(drive[rows] * speed[rows] < 0.0)) if rows.sum() >= FEWEST else 0.0
    if against < OFTEN:
        return ()
    what = "what drives is against the motion in nearly all rows in which both are there"
    right = (
        "drive and motion one way; if nothing else moves it (a weight, a spring, a hand), the sign "
        "of one of them is wrong in the map"
    )
    return (Finding.of_all(what, f"{100 * against:.0f} %", right),)
