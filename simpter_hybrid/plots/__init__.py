"""Pictures of a run, each a function from a trajectory to a Matplotlib figure."""

from __future__ import annotations

from pathlib import Path

from matplotlib.figure import Figure

from ..measuring.samples import Samples
from ..measuring.sampling import sample
from ..trajectory import Trajectory
from .clutches import clutch_torques, slip_velocities, torque_following
from .display import DISPLAYS, SI, THESIS, Display
from .motion import acceleration, energy_budget
from .style import png
from .tip_path import drawing_of, tip_path

__all__ = [
    "DISPLAYS",
    "SI",
    "THESIS",
    "Display",
    "acceleration",
    "clutch_torques",
    "drawing_of",
    "energy_budget",
    "figures",
    "plot",
    "png",
    "slip_velocities",
    "tip_path",
    "torque_following",
]


def figures(
    trajectory: Trajectory, samples: Samples | None = None, display: Display = SI
) -> dict[str, Figure]:
    """All pictures that a run can have, by name.

    Parameters
    ----------
    trajectory : Trajectory
    samples : Samples, optional
        What is drawn; the default output grid when left out.
    display : Display
        Units shown.

    Raises
    ------
    ValueError
        For a run that ended before it began.
    """
    if trajectory.t_end == 0.0:
        raise ValueError(
            f"the run has no duration, so that there is nothing to draw: {trajectory.message}"
        )
    s = sample(trajectory) if samples is None else samples
    made = {}
    if s.tip is not None:
        made["tip_path"] = tip_path(trajectory, s, display)
    m = s.tau.shape[1]
    if m > 0:
        made["slip_velocities"] = slip_velocities(trajectory, s, display)
        made["clutch_torques"] = clutch_torques(trajectory, s, display)
    if m > 0 and all(f"desired_{i + 1}" in s.held for i in range(m)):
        made["torque_following"] = torque_following(trajectory, s, display)
    made["acceleration"] = acceleration(trajectory, s, display)
    made["energy_budget"] = energy_budget(trajectory, s, display)
    return made


def plot(trajectory: Trajectory, directory: str | Path, display: Display = SI) -> list[Path]:
    """Write all pictures of a run into ``directory`` as PNG files; returns their paths."""
    pictures = figures(trajectory, display=display)
    directory = Path(directory)
    directory.mkdir(parents=True, exist_ok=True)
    written = []
    for name, picture in pictures.items():
        written.append(directory / f"{name}.png")
        written[-1].write_bytes(png(picture))
    return written
