"""Pictures of the clutches over time: slip velocities, torques, desired torques."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from ..kernel.records import ON, STICK
from ..measuring.samples import Samples
from ..trajectory import Trajectory
from .display import SI, Display
from .style import (
    GREY,
    INK,
    SKY,
    VERMILION,
    clutch_colour,
    event_handles,
    figure,
    mark_events,
    mode_handles,
    ribbon,
    styled,
)


def _legend(picture: Figure, handles: list, columns: int = 4) -> None:
    picture.legend(handles=handles, loc="outside lower center", ncols=columns)


#: What a surface gives, by its unit.
WORDS = {"N m": "torque", "N": "force"}


@styled
def slip_velocities(trajectory: Trajectory, samples: Samples, display: Display = SI) -> Figure:
    """Slip velocity of every clutch, with a ribbon that shows its mode."""
    surfaces = trajectory.scenario.device.surfaces
    unit = trajectory.scenario.device.surface_units[0]
    m, slip = len(surfaces), display.factor(unit) * samples.slip
    picture = figure(1.0 + 1.55 * m, "Slip velocities")
    axes = picture.subplots(
        2 * m, 1, sharex=True, squeeze=False, gridspec_kw={"height_ratios": [7, 1] * m}
    )[:, 0]
    top, bottom = slip.max(), slip.min()
    room = 0.06 * max(top - bottom, 1e-9)
    for i, name in enumerate(surfaces):
        ax, strip = axes[2 * i], axes[2 * i + 1]
        ax.axhline(0.0, color=GREY, linewidth=0.8)
        mark_events(ax, trajectory, i)
        ax.plot(samples.t, slip[:, i], color=clutch_colour(i))
        resting = np.where(samples.mode[:, i] == STICK, 0.0, np.nan)
        ax.plot(samples.t, resting, color=INK, linewidth=3.0)
        ax.set_ylim(bottom - room, top + room)
        ax.set_title(name)
        ax.set_ylabel(display.axis("slip", unit))
        ax.tick_params(labelbottom=False)
        ribbon(strip, trajectory, i)
        strip.set_ylabel("mode", rotation=0, ha="right", va="center", fontsize=9)
        strip.tick_params(labelbottom=i == m - 1)
    axes[-1].set_xlabel("time [s]")
    axes[-1].set_xlim(0.0, trajectory.t_end)
    _legend(picture, mode_handles(trajectory) + event_handles(trajectory), 7)
    return picture


@styled
def clutch_torques(trajectory: Trajectory, samples: Samples, display: Display = SI) -> Figure:
    """Torque of every clutch and its breakaway limits; where it is not unique, it is marked."""
    surfaces = trajectory.scenario.device.surfaces
    unit = trajectory.scenario.device.surface_units[1]
    m, k = len(surfaces), display.factor(unit)
    picture = figure(1.0 + 1.7 * m, "Clutch torques and breakaway limits")
    axes = picture.subplots(m, 1, sharex=True, squeeze=False)[:, 0]
    t = samples.t
    largest = k * max(samples.tau_break.max(), abs(samples.tau).max(), 1e-9)
    for i, (ax, name) in enumerate(zip(axes, surfaces, strict=True)):
        low, high = -k * samples.tau_break_forward[:, i], k * samples.tau_break_backward[:, i]
        ax.fill_between(t, low, high, color=SKY, alpha=0.25, linewidth=0.0)
        ax.plot(t, low, color=SKY, linewidth=0.8)
        ax.plot(t, high, color=SKY, linewidth=0.8)
        ax.axhline(0.0, color=GREY, linewidth=0.8)
        mark_events(ax, trajectory, i)
        tau = k * samples.tau[:, i]
        stuck = samples.mode[:, i] == STICK
        unique = samples.unique[:, i]
        ax.plot(t, tau, color=clutch_colour(i), linewidth=1.2)
        ax.plot(t, np.where(stuck & unique, tau, np.nan), color=INK, linewidth=2.4)
        ax.plot(t, np.where(unique, np.nan, tau), color=VERMILION, linewidth=2.4, linestyle="--")
        limit, used = max(abs(low).max(), abs(high).max()), max(abs(tau).max(), 0.02 * largest)
        remark = ""
        if (samples.gate[:, i] != ON).all():
            remark = ": off throughout"
        elif limit > 5.0 * used:
            remark = f" (limits up to {limit:.3g} {display.unit(unit)} lie outside the axis)"
        if limit > 5.0 * used or limit < used:
            ax.set_ylim(-1.3 * used, 1.3 * used)
        ax.set_title(name + remark)
        ax.set_ylabel(display.axis(WORDS[unit], unit))
    axes[-1].set_xlabel("time [s]")
    axes[-1].set_xlim(0.0, t[-1])
    handles: list = [
        Patch(facecolor=SKY, alpha=0.35, label="within the breakaway torque"),
        Line2D([], [], color=clutch_colour(0), label="slipping or off"),
        Line2D([], [], color=INK, linewidth=2.4, label="holding"),
    ]
    if not samples.unique.all():
        words = "holding, not unique (a convention is shown)"
        handles.append(Line2D([], [], color=VERMILION, linewidth=2.4, linestyle="--", label=words))
    _legend(picture, handles + event_handles(trajectory))
    return picture


@styled
def torque_following(trajectory: Trajectory, samples: Samples, display: Display = SI) -> Figure:
    """Desired torque of every clutch against the magnitude of its torque."""
    surfaces = trajectory.scenario.device.surfaces
    unit = trajectory.scenario.device.surface_units[1]
    m, k = len(surfaces), display.factor(unit)
    picture = figure(1.0 + 1.6 * m, "Desired and actual clutch torques")
    axes = picture.subplots(m, 1, sharex=True, squeeze=False)[:, 0]
    for i, (ax, name) in enumerate(zip(axes, surfaces, strict=True)):
        desired = k * abs(samples.held[f"desired_{i + 1}"])
        actual = k * abs(samples.tau[:, i])
        ax.plot(samples.t, desired, color=INK, linewidth=1.1, linestyle=(0, (3, 1.5)))
        ax.plot(samples.t, actual, color=clutch_colour(i))
        stuck = samples.mode[:, i] == STICK
        ax.plot(samples.t, np.where(stuck, actual, np.nan), color=INK, linewidth=2.4)
        ax.set_ylim(bottom=0.0)
        ax.set_title(name)
        ax.set_ylabel(display.axis(f"|{WORDS[unit]}|", unit))
    axes[-1].set_xlabel("time [s]")
    axes[-1].set_xlim(0.0, samples.t[-1])
    _legend(
        picture,
        [
            Line2D([], [], color=INK, linewidth=1.1, linestyle=(0, (3, 1.5)), label="desired"),
            Line2D([], [], color=clutch_colour(0), label="actual, slipping or off"),
            Line2D([], [], color=INK, linewidth=2.4, label="actual, holding"),
        ],
    )
    return picture
