"""The tip's path over the workspace, with the linkage drawn."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from ..desired_path import desired_path
from ..samples import Samples
from ..sampling import sample
from ..trajectory import Trajectory
from .display import SI, Display
from .style import (
    BLUE,
    EVENT_STYLES,
    GREEN,
    GREY,
    INK,
    WIDTH,
    event_style,
    figure,
    styled,
)

Polylines = list[list[tuple[float, float]]]


def drawing_of(device, q: Sequence[float]) -> Polylines:
    """The device's polylines at ``q`` [m], if it has a ``drawing``; else none."""
    draw = getattr(device, "drawing", None)
    return draw(q) if draw is not None else []


@styled
def tip_path(trajectory: Trajectory, samples: Samples, display: Display = SI) -> Figure:
    """Where the tip went, the linkage at some instants, and the distance from the desired path.

    Raises
    ------
    ValueError
        For a device without a tip.
    """
    if samples.tip is None:
        raise ValueError(f"{type(trajectory.scenario.device).__name__} has no tip to be drawn")
    k = display.factor("m")
    path = desired_path(trajectory.scenario)
    box = _box(trajectory, samples.tip, samples.q)
    wide, high = box[2] - box[0], box[3] - box[1]
    map_height = min(max((WIDTH - 1.2) * high / wide, 2.5), 6.5)
    picture = figure(map_height + (3.3 if path else 1.3), "Tip path over the workspace")
    axes = picture.subplots(
        2 if path else 1, 1, squeeze=False, height_ratios=[map_height, 1.7] if path else [1]
    )[:, 0]
    ax = axes[0]
    _links(ax, trajectory, k)
    if path is not None:
        outline = k * path.outline(samples.tip)
        ax.plot(*outline.T, color=GREEN, linewidth=4.0, alpha=0.45, solid_capstyle="butt")
    ax.plot(*(k * samples.tip).T, color=BLUE, linewidth=2.0)
    ax.plot(*(k * samples.tip[0]), "o", color=BLUE, markersize=8, markerfacecolor="white")
    ax.plot(*(k * samples.tip[-1]), "s", color=BLUE, markersize=7)
    ax.plot(0.0, 0.0, "o", color=INK, markersize=9, markerfacecolor="white", markeredgewidth=2.0)
    ax.set_xlim(k * box[0], k * box[2])
    ax.set_ylim(k * box[1], k * box[3])
    ax.set_aspect("equal")
    ax.set_xlabel(display.axis("x", "m"))
    ax.set_ylabel(display.axis("y", "m"))
    if path is not None:
        _offset(axes[1], trajectory, samples, path, display)
    _event_points(ax, axes[1] if path is not None else None, trajectory, path, k)
    _key(picture, trajectory, path is not None)
    return picture


def _box(
    trajectory: Trajectory, tip: np.ndarray, poses: np.ndarray
) -> tuple[float, float, float, float]:
    """What has to be seen [m]: the path and the linkage at the ends of the run."""
    points = [*tip.tolist(), (0.0, 0.0)]
    for q in (poses[0], poses[-1]):
        points += [point for line in drawing_of(trajectory.scenario.device, q) for point in line]
    corners = np.array(points)
    low, high = corners.min(axis=0), corners.max(axis=0)
    room = 0.05 * max(*(high - low), 1e-6)
    return (low[0] - room, low[1] - room, high[0] + room, high[1] + room)


def _links(ax: Axes, trajectory: Trajectory, k: float, ghosts: int = 5) -> None:
    """The linkage, pale in between and dark at the end."""
    times = np.linspace(0.0, trajectory.t_end, ghosts)
    poses = sample(trajectory, times, side="left").q
    for number, q in enumerate(poses):
        last = number == ghosts - 1
        for line in drawing_of(trajectory.scenario.device, q):
            xy = k * np.array(line)
            ax.plot(
                *xy.T,
                color=INK if last else GREY,
                alpha=0.9 if last else 0.16 + 0.08 * number,
                linewidth=3.0 if last else 2.0,
                marker="o",
                markersize=4 if last else 3,
                zorder=1.5,
            )


def _offset(ax: Axes, trajectory, samples, path, display: Display) -> None:
    """Distance from the desired path over time, magnified."""
    small = display.name == "SI"
    k, unit = (1e3, "mm") if small else (display.factor("m"), display.unit("m"))
    ax.axhline(0.0, color=GREEN, linewidth=4.0, alpha=0.45)
    ax.plot(samples.t, k * path.offset(samples.tip), color=BLUE)
    ax.set_xlim(0.0, trajectory.t_end)
    ax.set_xlabel("time [s]")
    ax.set_ylabel(f"off the path [{unit}]")


def _event_points(ax: Axes, below: Axes | None, trajectory, path, k: float) -> None:
    """Where the stick-slip events happened."""
    shown = [e for e in trajectory.events if e.kind in EVENT_STYLES]
    if not shown:
        return
    tips = sample(trajectory, [e.t for e in shown]).tip
    assert tips is not None
    for event, tip in zip(shown, tips, strict=True):
        colour, line, marker = event_style(event.kind)
        ax.plot(*(k * tip), marker, color=colour, markersize=8, markeredgecolor="white", zorder=4)
        if below is not None:
            below.axvline(event.t, color=colour, linestyle=line, linewidth=0.8, alpha=0.6)


def _key(picture: Figure, trajectory: Trajectory, with_path: bool) -> None:
    kinds = {event.kind for event in trajectory.events}
    handles = [Line2D([], [], color=BLUE, linewidth=2.0, label="tip")]
    if with_path:
        handles.append(Line2D([], [], color=GREEN, linewidth=4.0, alpha=0.45, label="desired path"))
    handles += [
        Line2D([], [], color=BLUE, marker="o", markerfacecolor="white", ls="", label="start"),
        Line2D([], [], color=BLUE, marker="s", ls="", label="end"),
    ]
    for kind, words in (("breakaway", "breakaway"), ("slip stop", "stop of slip")):
        if kind in kinds:
            colour, _, marker = event_style(kind)
            handles.append(Line2D([], [], color=colour, marker=marker, ls="", label=words))
    picture.legend(handles=handles, loc="outside lower center", ncols=len(handles))
