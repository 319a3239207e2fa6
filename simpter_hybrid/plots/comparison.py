"""Pictures of a comparison: errors against band and cost, the tips' paths, one transition."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from ..comparison.compare import WINDOW, Comparison
from ..comparison.events import Change, changes, match
from ..comparison.states import clutch_maps, points_of, states_at
from .display import SI, Display
from .style import CLUTCH_COLOURS, GREY, INK, figure, styled

MARKERS = "osD^vP*X"


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
    left.set_xlabel("band or width [rad/s]")
    left.set_ylabel("error of the final coordinates [rad or m]")
    right.set_xlabel("evaluations of the right-hand side")
    right.legend()
    return picture


@styled
def tip_paths(comparison: Comparison, display: Display = SI) -> Figure:
    """All tips' paths (coordinates, where there is no tip) beside the exact one."""
    k = display.factor("m")
    picture = figure(4.6, f"{comparison.scenario.name}: paths")
    ax = picture.subplots()
    for number, (name, run) in enumerate(
        [*((r.name, t) for r, t in zip(comparison.rows, comparison.runs, strict=True)),
         ("exact", comparison.reference)]
    ):  # fmt: skip
        times = np.linspace(0.0, run.t_end, 601)
        points = k * points_of(comparison.scenario, states_at(run, times))
        exact = name == "exact"
        colour = INK if exact else CLUTCH_COLOURS[number % 8]
        across = points[:, 0] if points.shape[1] > 1 else times
        ax.plot(
            across, points[:, -1] if points.shape[1] == 1 else points[:, 1], color=colour,
            linewidth=2.2 if exact else 1.2, linestyle="-" if exact else "--", label=name,
        )  # fmt: skip
    ax.set_xlabel(display.axis("x", "m"))
    ax.set_ylabel(display.axis("y", "m"))
    ax.legend()
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
    named = [
        *zip((r.name for r in comparison.rows), comparison.runs, strict=True),
        ("exact", exact),
    ]
    n = comparison.scenario.device.n
    for k, (name, run) in enumerate(named):
        states = states_at(run, times)
        rows = clutch_maps(comparison.scenario, states)[:, shown.clutch - 1]
        slip = np.einsum("kj,kj->k", rows, states[:, n : 2 * n])
        last = name == "exact"
        ax.plot(
            times, slip, color=INK if last else CLUTCH_COLOURS[k % 8], label=name,
            linewidth=2.2 if last else 1.2, linestyle="-" if last else "--",
        )  # fmt: skip
    ax.axhline(0.0, color=GREY, linewidth=0.8)
    ax.set_xlabel("time [s]")
    ax.set_ylabel("slip velocity [rad/s]")
    ax.legend()
    return picture


def comparison_figures(comparison: Comparison, display: Display = SI) -> dict[str, Figure]:
    """All pictures of a comparison by name."""
    found = {
        "error_and_cost": error_against_band(comparison),
        "paths": tip_paths(comparison, display),
    }
    zoom = one_transition(comparison)
    if zoom is not None:
        found["one_transition"] = zoom
    return found
