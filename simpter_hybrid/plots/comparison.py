"""Pictures of a comparison: errors against band and cost, the tips' paths, one transition."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from ..comparison.bounds import unit_of
from ..comparison.compare import WINDOW, Comparison
from ..comparison.events import Change, changes, match
from ..comparison.states import clutch_maps, points_of, states_at
from ..trajectory import Trajectory
from .display import SI, Display
from .style import CLUTCH_COLOURS, GREY, INK, figure, styled

MARKERS = "osD^vP*X"
#: Names of all pictures that a comparison may have.
FIGURES = ("error_and_cost", "paths", "one_transition")


def families(comparison: Comparison) -> dict[str, list[int]]:
    """Numbers of the rows of every family, in the order of their size."""
    found: dict[str, list[int]] = {}
    for k, row in enumerate(comparison.rows):
        found.setdefault(row.family, []).append(k)
    return {
        name: sorted(rows, key=lambda k: comparison.rows[k].size) for name, rows in found.items()
    }


@styled
def error_against_band(comparison: Comparison) -> Figure:
    """Final error against band, and against the evaluations of the right-hand side it took."""
    picture = figure(4.2, f"{comparison.scenario.name}: error and cost")
    left, right = picture.subplots(1, 2, sharey=True)
    for k, (name, rows) in enumerate(families(comparison).items()):
        good = [comparison.rows[j] for j in rows if comparison.rows[j].status != "failed"]
        error = [max(row.final_error, 1e-16) for row in good]
        style = {"color": CLUTCH_COLOURS[k % 8], "marker": MARKERS[k % 8], "label": name}
        left.loglog([row.size for row in good], error, **style)
        right.loglog([row.rhs_evaluations for row in good], error, **style)
    right.axvline(
        comparison.reference.statistics["rhs_evaluations"], color=GREY, linestyle="--",
        linewidth=1.0, label="exact engine",
    )  # fmt: skip
    device = comparison.scenario.device
    left.set_xlabel(f"band or width [{device.surface_units[0]}]")
    left.set_ylabel(f"error of the final coordinates [{unit_of('final_error', device)}]")
    right.set_xlabel("evaluations of the right-hand side")
    label_counts(right)
    right.legend()
    return picture


def label_counts(ax: Axes) -> None:
    """Labels of a logarithmic axis of counts that do not run into each other."""
    low, high = ax.get_xlim()
    ax.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0) if high < 100.0 * low else (1.0,)))
    ax.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:,.0f}"))
    ax.xaxis.set_minor_formatter(NullFormatter())


def named_runs(comparison: Comparison) -> list[tuple[str, Trajectory, dict[str, Any]]]:
    """Name, run and line style of all, the exact run last."""
    found: list[tuple[str, Trajectory, dict[str, Any]]] = []
    for k, (row, run) in enumerate(zip(comparison.rows, comparison.runs, strict=True)):
        line = ("--", ":", "-.")[k // 8 % 3]
        style = {"color": CLUTCH_COLOURS[k % 8], "linewidth": 1.2, "linestyle": line}
        found.append((row.name, run, style))
    return [*found, ("exact", comparison.reference, {"color": INK, "linewidth": 2.2})]


def legend_beside(picture: Figure, ax: Axes) -> None:
    """The legend of one panel to the right of all, where it hides no curve."""
    picture.legend(*ax.get_legend_handles_labels(), loc="outside right upper")


@styled
def paths(comparison: Comparison, display: Display = SI) -> Figure:
    """All tips' paths beside the exact one, or where there is no tip the coordinates over time."""
    scenario = comparison.scenario
    if "tip" not in scenario.device.functions():
        return coordinates(comparison)
    k = display.factor("m")
    picture = figure(4.6, f"{scenario.name}: paths")
    ax = picture.subplots()
    for name, run, style in named_runs(comparison):
        states = states_at(run, np.linspace(0.0, run.t_end, 601))
        x, y = k * points_of(scenario, states).T
        ax.plot(x, y, label=name, **style)
    ax.set_xlabel(display.axis("x", "m"))
    ax.set_ylabel(display.axis("y", "m"))
    legend_beside(picture, ax)
    return picture


def coordinates(comparison: Comparison) -> Figure:
    """The first four coordinates over time."""
    device = comparison.scenario.device
    shown = device.coordinates[:4]
    kinds = device.coordinate_dimensions or ("angle",) * device.n
    picture = figure(2.2 + 1.6 * len(shown), f"{comparison.scenario.name}: coordinates")
    axes = picture.subplots(len(shown), 1, sharex=True, squeeze=False)[:, 0]
    for name, run, style in named_runs(comparison):
        times = np.linspace(0.0, run.t_end, 601)
        states = states_at(run, times)
        for j, ax in enumerate(axes):
            ax.plot(times, states[:, j], label=name, **style)
    for ax, coordinate, kind in zip(axes, shown, kinds, strict=False):
        ax.set_ylabel(f"{coordinate} [{'m' if kind == 'length' else 'rad'}]")
    axes[-1].set_xlabel("time [s]")
    legend_beside(picture, axes[0])
    return picture


def first_difference(comparison: Comparison) -> Change | None:
    """The first stop or release of the exact run that a candidate misses or shifts by 1 ms.

    Else the one shifted most; None where the exact run has none.
    """
    exact = comparison.reference
    mine = changes(exact, exact.t_end)
    shift = dict.fromkeys(mine, 0.0)
    for run in comparison.runs:
        until = min(run.t_end, exact.t_end)
        found = match([c for c in mine if c.t <= until], changes(run, until), WINDOW)
        shift |= dict.fromkeys(found.missed, WINDOW)
        for a, b in found.pairs:
            shift[a] = max(shift[a], abs(a.t - b.t))
    visible = (change for change in mine if shift[change] >= 1e-3)
    return next(visible, max(mine, key=lambda change: shift[change], default=None))


@styled
def one_transition(comparison: Comparison) -> Figure | None:
    """Slip velocity around the first change at which a difference can be seen, if there is one."""
    exact = comparison.reference
    shown = first_difference(comparison)
    if shown is None:
        return None
    span = 1.5 * WINDOW
    times = np.linspace(max(shown.t - span, 0.0), min(shown.t + span, exact.t_end), 801)
    picture = figure(4.2, f"Clutch {shown.clutch} around t = {shown.t:.4f} s")
    ax = picture.subplots()
    device = comparison.scenario.device
    n = device.n
    for name, run, style in named_runs(comparison):
        states = states_at(run, times)
        rows = clutch_maps(comparison.scenario, states)[:, shown.clutch - 1]
        slip = np.einsum("kj,kj->k", rows, states[:, n : 2 * n])
        ax.plot(times, slip, label=name, **style)
    ax.axhline(0.0, color=GREY, linewidth=0.8)
    ax.set_xlabel("time [s]")
    ax.set_ylabel(f"slip velocity [{device.surface_units[0]}]")
    legend_beside(picture, ax)
    return picture


def comparison_figures(comparison: Comparison, display: Display = SI) -> dict[str, Figure]:
    """All pictures of a comparison by name, out of ``FIGURES``."""
    found = {
        "error_and_cost": error_against_band(comparison),
        "paths": paths(comparison, display),
    }
    zoom = one_transition(comparison)
    if zoom is not None:
        found["one_transition"] = zoom
    return found
