"""The tip's path over the workspace, with the linkage drawn."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from ..kernel.records import STICK
from ..measuring.desired_path import desired_path
from ..measuring.samples import Samples
from ..measuring.sampling import sample
from ..trajectory import Trajectory
from .display import SI, Display
from .style import (
    BLUE,
    EVENT_STYLES,
    GREEN,
    GREY,
    INK,
    ORANGE,
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
    map_height = min(max((WIDTH - 1.2) * high / wide, 2.5), 6.0)
    picture = figure(map_height + 3.6, "Tip path over the workspace")
    whole, below = picture.subplots(2, 1, height_ratios=[map_height, 2.0])
    curve = curve_left(trajectory, samples)
    _links(whole, trajectory, k)
    whole.plot(0.0, 0.0, "o", color=INK, markersize=9, markerfacecolor="white", mew=2.0)
    for ax in (whole,) if path is not None else (whole, below):
        _tip(ax, trajectory, samples, path, curve, k)
        ax.set_aspect("equal", adjustable="box" if ax is whole else "datalim")
        ax.set_xlabel(display.axis("x", "m"))
        ax.set_ylabel(display.axis("y", "m"))
    whole.set_xlim(k * box[0], k * box[2])
    whole.set_ylim(k * box[1], k * box[3])
    if path is not None:
        _offset(below, trajectory, samples, path, display)
    else:
        below.set_title("enlarged")
    _key(picture, trajectory, path is not None, curve is not None)
    return picture


def curve_left(trajectory: Trajectory, samples: Samples) -> np.ndarray | None:
    """The curve on which clutches that are stuck throughout keep the tip [m]; (K, 2).

    None unless they leave one degree of freedom and the clutch map is constant (the coordinates
    then move along a straight line).
    """
    device = trajectory.scenario.device
    held = np.flatnonzero((samples.mode == STICK).all(axis=0))
    if samples.tip is None or len(held) == 0 or not device.constant_clutch_map:
        return None
    n, p = device.n, trajectory.scenario.parameter_values()
    functions = device.functions()
    clutch_map = [0.0] * (device.m * n)
    functions["clutch_map"](samples.q[0].tolist(), p, clutch_map)
    rows = np.reshape(clutch_map, (device.m, n))[held]
    if np.linalg.matrix_rank(rows) != n - 1:
        return None
    free = np.linalg.svd(rows)[2][-1]
    along = (samples.q - samples.q[0]) @ free
    room = 0.3 * float(np.ptp(along)) + 0.01
    curve = np.zeros((101, 2))
    for k, way in enumerate(np.linspace(along.min() - room, along.max() + room, len(curve))):
        functions["tip"]((samples.q[0] + way * free).tolist(), p, curve[k])
    return curve


def _tip(ax: Axes, trajectory: Trajectory, samples: Samples, path, curve, k: float) -> None:
    """The tip's path with what it was to follow and where the stick-slip events happened."""
    assert samples.tip is not None
    if path is not None:
        outline = k * path.outline(samples.tip)
        ax.plot(*outline.T, color=GREEN, linewidth=4.0, alpha=0.45, solid_capstyle="butt")
    if curve is not None:
        ax.plot(*(k * curve).T, color=ORANGE, linewidth=3.5, alpha=0.6)
    ax.plot(*(k * samples.tip).T, color=BLUE, linewidth=2.0)
    ax.plot(*(k * samples.tip[0]), "o", color=BLUE, markersize=8, markerfacecolor="white")
    ax.plot(*(k * samples.tip[-1]), "s", color=BLUE, markersize=7)
    shown = [event for event in trajectory.events if event.kind in EVENT_STYLES]
    if shown:
        tips = sample(trajectory, [event.t for event in shown]).tip
        assert tips is not None
        for event, tip in zip(shown, tips, strict=True):
            colour, _, mark = event_style(event.kind)
            ax.plot(*(k * tip), mark, color=colour, markersize=8, mec="white", zorder=4)


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
    for event in trajectory.events:
        if event.kind in EVENT_STYLES:
            colour, line, _ = event_style(event.kind)
            ax.axvline(event.t, color=colour, linestyle=line, linewidth=0.8, alpha=0.6)


def _key(picture: Figure, trajectory: Trajectory, with_path: bool, with_curve: bool) -> None:
    kinds = {event.kind for event in trajectory.events}
    handles = [Line2D([], [], color=BLUE, linewidth=2.0, label="tip")]
    if with_path:
        handles.append(Line2D([], [], color=GREEN, linewidth=4.0, alpha=0.45, label="desired path"))
    if with_curve:
        words = "curve left by the stuck clutches"
        handles.append(Line2D([], [], color=ORANGE, linewidth=3.5, alpha=0.6, label=words))
    handles += [
        Line2D([], [], color=BLUE, marker="o", markerfacecolor="white", ls="", label="start"),
        Line2D([], [], color=BLUE, marker="s", ls="", label="end"),
    ]
    for kind, words in (("breakaway", "breakaway"), ("slip stop", "stop of slip")):
        if kind in kinds:
            colour, _, marker = event_style(kind)
            handles.append(Line2D([], [], color=colour, marker=marker, ls="", label=words))
    picture.legend(handles=handles, loc="outside lower center", ncols=len(handles))
