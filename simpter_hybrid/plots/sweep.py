"""Pictures of a sweep: lines over one parameter, maps over two, scatters over more."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..sweeps.brief import unit_and_label
from ..sweeps.indices import indices, varying
from ..sweeps.table import Table
from .display import SI, Display
from .style import BLUE, GREY, INK, ORANGE, PALE, VERMILION, figure, styled

#: Measures drawn where none are named, if there are any of them and they vary.
DRAWN = ("average_error", "average_jerk", "run_time", "transitions", "max_error", "events")
#: Panels of one picture, and rows of a scatter, at most where no measures are named.
PANELS, SCATTERED = 6, 4


def sweep_figures(
    table: Table, display: Display = SI, show: Sequence[str] | None = None
) -> dict[str, Figure]:
    """The pictures of a sweep by name.

    Parameters
    ----------
    table : Table
    display : Display
        Units of the measures.
    show : sequence of str, optional
        Measures to draw; those that no case has are left out.
    """
    names = [name for name in (show or varying(table)) if name in table.measures]
    if not show:
        preferred = [name for name in DRAWN if name in names]
        names = (preferred + [n for n in names if n not in preferred])[:PANELS]
    scattered = names if show else names[:SCATTERED]
    if not names:
        return {}
    grid = table.design.grid
    whole_grid = len(grid) == len(table.design.paths)
    numeric = all(table.unit(path) is not None for path in table.design.paths)
    if whole_grid and len(grid) == 1 and numeric:
        made = {"lines": lines(table, names, display)}
    elif whole_grid and len(grid) == 2 and numeric:
        made = {"maps": maps(table, names, display)}
    elif len(grid) == 1 and numeric:
        made = {"bands": bands(table, names, display),
                "scatter": scatter(table, scattered, display)}  # fmt: skip
    else:
        made = {"scatter": scatter(table, scattered, display)}
    if table.design.saltelli:
        made["sobol"] = sobol(table, names, display)
    return made


def panels(count: int, title: str, height: float = 2.6) -> tuple[Figure, list[Axes]]:
    """A picture with ``count`` panels in two columns."""
    rows = (count + 1) // 2
    picture = figure(height * rows + 0.4, title)
    axes = np.ravel(picture.subplots(rows, min(count, 2), squeeze=False))
    for ax in axes[count:]:
        ax.set_axis_off()
    return picture, list(axes[:count])


def shown(table: Table, name: str, display: Display) -> tuple[np.ndarray, str]:
    """Values of a measure in the units shown, and the words for them."""
    unit, label = unit_and_label(name, table.device)
    words = label.split(",")[0].split(" (")[0]
    clutch = label.rpartition(", clutch ")[2] if ", clutch " in label else ""
    words += f", clutch {clutch}" if clutch else ""
    return table.column(name) * display.factor(unit), display.axis(words, unit) if unit else words


def axis_label(table: Table, path: str) -> str:
    """``gain [V/(lbf*in)]``: the last parts of a path."""
    parts = path.split(".")
    name = ".".join(parts[-2:]) if parts[-1].isdigit() else parts[-1]
    unit = table.unit(path)
    return f"{name} [{unit}]" if unit else name


def title_of(table: Table) -> str:
    """How many cases, how many failed."""
    bad = len(table.failed)
    return f"{len(table)} cases" + (f", {bad} failed" if bad else "")


@styled
def lines(table: Table, names: Sequence[str], display: Display) -> Figure:
    """Every measure over the one parameter; failed cases are ticks at the bottom."""
    path = table.design.paths[0]
    x = table.column(path)
    picture, axes = panels(len(names), title_of(table))
    order = np.argsort(x, kind="stable")
    for ax, name in zip(axes, names, strict=True):
        values, words = shown(table, name, display)
        marker = "o" if len(x) <= 60 else ""
        ax.plot(x[order], values[order], color=BLUE, marker=marker, markersize=3.5)
        mark_failed(ax, x[table.failed])
        ax.set_xlabel(axis_label(table, path))
        ax.set_ylabel(words)
    return picture


def mark_failed(ax: Axes, x: np.ndarray) -> None:
    """Crosses at the bottom where cases failed."""
    if len(x):
        ax.plot(
            x, np.zeros(len(x)), "x", color=VERMILION, markersize=6, clip_on=False,
            transform=ax.get_xaxis_transform(), label="failed",
        )  # fmt: skip
        ax.legend()


@styled
def maps(table: Table, names: Sequence[str], display: Display) -> Figure:
    """Every measure over two parameters; grey where a case failed."""
    first, second = table.design.paths
    x, y = table.column(first), table.column(second)
    shape = table.design.grid
    picture, axes = panels(len(names), title_of(table), 3.2)
    across, up = np.argsort(x.reshape(shape)[:, 0]), np.argsort(y.reshape(shape)[0])
    for ax, name in zip(axes, names, strict=True):
        values, words = shown(table, name, display)
        field = values.reshape(shape)[across][:, up]
        ax.set_facecolor(PALE)
        drawn = ax.pcolormesh(
            edges(x.reshape(shape)[across, 0]), edges(y.reshape(shape)[0, up]),
            np.ma.masked_invalid(field.T), cmap="viridis", rasterized=True,
        )  # fmt: skip
        ax.grid(False)
        picture.colorbar(drawn, ax=ax, label=words)
        ax.set_xlabel(axis_label(table, first))
        ax.set_ylabel(axis_label(table, second))
    return picture


def edges(values: np.ndarray) -> np.ndarray:
    """Edges (k + 1,) of cells around rising values (k,): half way to the next ones.

    A value that is alone has no next one: its cell is as wide as it is large, or 1 around 0.
    """
    if len(values) == 1:
        return values + (abs(values[0]) or 1.0) * np.array([-0.5, 0.5])
    half = 0.5 * np.diff(values)
    inner = values[:-1] + half
    return np.concatenate([[values[0] - half[0]], inner, [values[-1] + half[-1]]])


@styled
def bands(table: Table, names: Sequence[str], display: Display) -> Figure:
    """Every measure over the one grid parameter: median and quantiles over everything else."""
    path = table.design.paths[0]
    count = table.design.grid[0]
    x = table.column(path).reshape(count, -1)[:, 0]
    order = np.argsort(x, kind="stable")
    picture, axes = panels(len(names), title_of(table))
    for ax, name in zip(axes, names, strict=True):
        values, words = shown(table, name, display)
        rows = values.reshape(count, -1)[order]
        there = np.isfinite(rows).any(axis=1)
        at, rows = x[order][there], rows[there]
        low, first, middle, third, high = np.nanpercentile(rows, [5, 25, 50, 75, 95], axis=1)
        ax.fill_between(at, low, high, color=BLUE, alpha=0.15, linewidth=0, label="5 to 95 %")
        ax.fill_between(at, first, third, color=BLUE, alpha=0.3, linewidth=0, label="25 to 75 %")
        ax.plot(at, middle, color=INK, label="median")
        ax.set_xlabel(axis_label(table, path))
        ax.set_ylabel(words)
    axes[0].legend()
    return picture


@styled
def scatter(table: Table, names: Sequence[str], display: Display) -> Figure:
    """Every measure against every parameter; where values are no numbers, a violin for each."""
    paths = table.design.paths[:PANELS]
    picture = figure(2.3 * len(names) + 0.5, title_of(table))
    axes = picture.subplots(len(names), len(paths), squeeze=False, sharey="row")
    for row, name in zip(axes, names, strict=True):
        values, words = shown(table, name, display)
        row[0].set_ylabel(words)
        for ax, path in zip(row, paths, strict=True):
            if table.unit(path) is None:
                violins(ax, table.given(path), values)
            else:
                size = 4.0 if len(values) > 400 else 10.0
                alpha = 0.3 if len(values) > 400 else 0.7
                ax.scatter(
                    table.column(path), values, s=size, color=BLUE, alpha=alpha, linewidth=0,
                    rasterized=True,
                )  # fmt: skip
    for ax, path in zip(axes[-1], paths, strict=True):
        ax.set_xlabel(axis_label(table, path))
    return picture


def violins(ax: Axes, given: Sequence[str], values: np.ndarray) -> None:
    """The distribution of the values for each of what was given."""
    words = list(dict.fromkeys(given))
    chosen = np.array([words.index(word) for word in given])
    for k in range(len(words)):
        those = values[(chosen == k) & np.isfinite(values)]
        if len(those) > 2 and np.ptp(those) > 0.0:
            parts = ax.violinplot(those, [k], showmedians=True, showextrema=False)
            for body in parts["bodies"]:  # type: ignore[attr-defined]
                body.set_facecolor(BLUE)
        else:
            ax.plot(np.full(len(those), k), those, "o", color=BLUE, markersize=4)
    ax.set_xticks(range(len(words)), [word.strip("\"'")[:18] for word in words])


@styled
def sobol(table: Table, names: Sequence[str], display: Display) -> Figure:
    """First-order and total indices of every measure, with their intervals."""
    paths = table.design.paths
    picture, axes = panels(len(names), "Sobol indices (lines: 95 % bootstrap intervals)")
    at = np.arange(len(paths))
    for ax, name in zip(axes, names, strict=True):
        try:
            its = indices(table, name)
        except ValueError as error:
            ax.text(0.02, 0.5, str(error), transform=ax.transAxes, color=GREY)
            continue
        for shift, colour, values, interval, label in (
            (-0.2, BLUE, its.first, its.first_interval, "first order"),
            (0.2, ORANGE, its.total, its.total_interval, "total"),
        ):
            ax.bar(at + shift, values, 0.36, color=colour, label=label)
            ax.vlines(at + shift, interval[:, 0], interval[:, 1], color=INK, linewidth=1.0)
        ax.set_xticks(at, [axis_label(table, path).split(" [")[0] for path in paths])
        ax.set_title(shown(table, name, display)[1].split(" [")[0])
    axes[0].legend(frameon=True, framealpha=0.8)
    return picture
