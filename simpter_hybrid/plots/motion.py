"""Pictures of acceleration and energy over time."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from ..measuring.energy import residual, stored_energy
from ..measuring.samples import Samples
from ..trajectory import Trajectory
from .display import SI, Display
from .style import (
    BLUE,
    GREY,
    INK,
    ORANGE,
    SKY,
    VERMILION,
    clutch_colour,
    event_handles,
    figure,
    mark_events,
    styled,
)


def jumps_in(t: np.ndarray, value: np.ndarray) -> np.ndarray:
    """Indices k such that ``value`` (N,) visibly jumps from k to k + 1."""
    seen = 1e-3 * max(float(np.ptp(value)), 1e-300)
    return np.flatnonzero((np.diff(t) == 0.0) & (abs(np.diff(value)) > seen))


def draw_broken(ax: Axes, t: np.ndarray, value: np.ndarray, **style: Any) -> None:
    """A curve with its jumps dotted."""
    jumps = jumps_in(t, value)
    gaps = jumps + 1
    ax.plot(np.insert(t, gaps, t[gaps]), np.insert(value, gaps, np.nan), **style)
    for k in jumps:
        dotted = style | {"linestyle": ":", "linewidth": 1.0}
        ax.plot(t[k : k + 2], value[k : k + 2], **dotted)


@styled
def acceleration(trajectory: Trajectory, samples: Samples, display: Display = SI) -> Figure:
    """Acceleration of the tip, or of the coordinates where there is no tip; jumps are dotted."""
    if samples.tip_acceleration is None:
        curves = dict(zip(trajectory.scenario.device.coordinates, samples.qdd.T, strict=True))
        kinds = set(trajectory.scenario.device.coordinate_dimensions) or {"angle"}
        unit = {"angle": "rad/s²", "length": "m/s²"}[kinds.pop()] if len(kinds) == 1 else "SI"
        title, label = "Acceleration of the coordinates", f"acceleration [{unit}]"
    else:
        a = display.factor("m/s^2") * samples.tip_acceleration
        curves = {"magnitude": np.hypot(*a.T), "x": a[:, 0], "y": a[:, 1]}
        title, label = "Acceleration of the tip", display.axis("acceleration", "m/s^2")
    picture = figure(3.6, title)
    ax = picture.subplots()
    mark_events(ax, trajectory)
    ax.axhline(0.0, color=GREY, linewidth=0.8)
    styles = [(INK, "-", 2.0), (BLUE, "-", 1.2), (ORANGE, "--", 1.4), (SKY, "-.", 1.2)]
    handles = []
    for (name, values), (colour, line, width) in zip(curves.items(), 3 * styles, strict=False):
        style: dict[str, Any] = {"color": colour, "linestyle": line, "linewidth": width}
        draw_broken(ax, samples.t, values, **style)
        handles.append(Line2D([], [], label=name, **style))
    handles.append(Line2D([], [], color=INK, linestyle=":", linewidth=1.0, label="jump"))
    ax.set_xlim(0.0, trajectory.t_end)
    ax.set_xlabel("time [s]")
    ax.set_ylabel(label)
    picture.legend(handles=handles + event_handles(trajectory), loc="outside lower center", ncols=7)
    return picture


@styled
def energy_budget(trajectory: Trajectory, samples: Samples, display: Display = SI) -> Figure:
    """Where the energy went, and by how much the budget is missed."""
    k, t = display.factor("J"), samples.t
    stored, missing = stored_energy(samples), residual(samples)
    known = stored is not None and missing is not None
    picture = figure(4.9 if known else 3.6, "Energy budget")
    axes = picture.subplots(
        2 if known else 1, 1, sharex=True, squeeze=False, height_ratios=[3.2, 1] if known else [1]
    )[:, 0]
    layers, labels, colours = [], [], []
    for i, column in enumerate(samples.dissipated.T):
        layers.append(k * column)
        labels.append(f"dissipated by {trajectory.scenario.device.surfaces[i]}")
        colours.append(clutch_colour(i))
    supplied = samples.work_load + samples.work_effects
    if stored is not None:
        layers.insert(0, k * (stored - min(stored.min(), 0.0)))
        labels.insert(0, "stored (kinetic and potential)")
        colours.insert(0, "#BBBBBB")
        supplied = supplied + stored[0] - min(stored.min(), 0.0)
    if layers:  # nothing rubs, and what is stored is not known
        axes[0].stackplot(
            t, *layers, labels=labels, colors=colours, alpha=0.85, edgecolor="white", linewidth=0.4
        )
    axes[0].plot(t, k * supplied, color=INK, linewidth=2.0, linestyle="--", label="put in")
    axes[0].set_ylabel(display.axis("energy", "J"))
    axes[0].set_title(
        "The areas add up to what was put in"
        if known
        else "The stored energy is not known: the device has no potential_energy"
    )
    if stored is not None and missing is not None:
        scale = max(abs(supplied).max(), stored.max(), 1e-300)
        axes[1].semilogy(t, np.maximum(abs(missing) / scale, 1e-18), color=VERMILION, linewidth=1.0)
        axes[1].set_ylim(1e-18, max(1e-8, 10.0 * abs(missing).max() / scale))
        axes[1].set_ylabel("missing [1]")
    axes[-1].set_xlim(0.0, trajectory.t_end)
    axes[-1].set_xlabel("time [s]")
    handles, words = axes[0].get_legend_handles_labels()
    picture.legend(handles, words, loc="outside lower center", ncols=3)
    return picture
