"""A function of a device (``mass_matrix``, ``clutch_map``, ``tip``) over poses."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..device import Device


def over_poses(
    device: Device, name: str, poses: np.ndarray, size: int, numbers: Sequence[float] = ()
) -> np.ndarray:
    """What a function of the device writes in every pose (poses, size).

    Parameters
    ----------
    device : Device
    name : str
        Of a function of ``q, p, out``.
    poses : ndarray (poses, n)
        Coordinates [rad or m].
    size : int
        How many numbers it writes.
    numbers : sequence of float
        What stands in the place of the device's own parameters and table.
    """
    function = device.functions()[name]
    given = list(numbers) or [*device.parameters().values(), *device.table()]
    found = np.empty((len(poses), size))
    for k, q in enumerate(np.asarray(poses, dtype=float).tolist()):
        out = [0.0] * size
        function(q, given, out)
        found[k] = out
    return found
