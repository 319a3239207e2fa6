"""Late drivers of runs that begin at rest: whether their first drive had been told before."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence

import numpy as np

from ...controller import Controller
from ...controllers.drive_delay import DriveDelay

#: A drive is what it was first until it is off by more than this part of its largest.
SAME = 0.02
#: What has gone more than this part of a run's longest way has left its place.
LEFT = 0.05
#: So long it has to stand under its first drive to have stood there before the start, too [s]:
#: twice the longest delay that is looked for.
STOOD = 0.1


def left_as_told(time: np.ndarray, position: np.ndarray, told: np.ndarray) -> bool | None:
    """Whether what was at rest at the start leaves its place under the drive of the first row.

    If it does, that cannot have been told for long: it would have left before.  An arm that is
    held against its weight stands there until it is told something else.

    Parameters
    ----------
    time, position, told : ndarray (samples,)
        Of one run [SI]; the drive in any unit.

    Returns
    -------
    bool or None
        False if it stood for `STOOD`; None if the drive changes too early to tell.
    """
    changed = np.abs(told - told[0]) > SAME * float(np.nanmax(np.abs(told)))
    rows = int(np.argmax(changed)) if changed.any() else told.size
    way = np.abs(position - position[0])
    if np.nanmax(way[:rows]) > LEFT * float(np.nanmax(way)):
        return True
    return False if time[rows - 1] - time[0] >= STOOD else None


def delayed_from_rest(
    parameters: np.ndarray,
    names: Mapping[str, int],
    stages: Sequence[tuple[Controller, int]],
    period: float,
    resting: Callable[[], Collection[int]],
) -> np.ndarray:
    """Parameters in which delays of these coordinates' drives begin with nothing told before.

    Parameters
    ----------
    parameters : ndarray (np,)
    names : mapping of str to int
        Entries of `parameters` by name.
    stages : sequence of (Controller, int)
        Those of the scenario that is run, in its order.
    period : float
        At which they act [s].
    resting : callable
        Coordinates of which nothing was told before the start; asked if need be.
    """
    late = [
        (int(stage.coordinate), names[f"controller.{number}.from_rest"])
        for number, (stage, _) in enumerate(stages, 1)
        if isinstance(stage, DriveDelay)
    ]
    entries = [entry for j, entry in late if j in resting()] if late else []
    if entries:
        parameters = parameters.copy()
        parameters[entries] = period
    return parameters
