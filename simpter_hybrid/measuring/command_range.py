"""Commands beyond what a clutch is made for: its torque map goes on there, the clutch may not."""

from __future__ import annotations

import numpy as np

from ..trajectory import Trajectory

#: Of full scale; a command beyond it by less is a rounded one.
ROUNDED = 1e-9


def beyond_range(trajectory: Trajectory) -> list[str]:
    """For how long every clutch was commanded beyond 0 V to its full scale, in words.

    Parameters
    ----------
    trajectory : Trajectory

    Returns
    -------
    list of str
        Of the clutches of which there is something to tell.
    """
    lasted = trajectory.segment_t[:, 1] - trajectory.segment_t[:, 0]
    found = []
    for i, clutch in enumerate(trajectory.scenario.clutches):
        held, full = trajectory.held[:, i], clutch.full_scale
        beyond = (held < -ROUNDED * full) | (held > (1.0 + ROUNDED) * full)
        if time := float(np.sum(lasted[beyond])):
            least, most = float(held[beyond].min()), float(held[beyond].max())
            found.append(
                f"clutch {i + 1} was commanded beyond its range (0 V to {full:g} V) for {time:.3g} "
                f"of {trajectory.t_end:.3g} s (from {least:.3g} V to {most:.3g} V): nothing cut it "
                "to that"
            )
    return found
