"""Variants of the line-following run side by side: nominal, and over plausible inputs in pairs."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

import numpy as np

from ..loads.operator import Operator
from ..reproduce.standard import CONTROLLERS
from ..rigs.inputs import Inputs, drawn, nominal
from ..scenario import Scenario
from .batch import Measured, measured
from .study import Table

#: A variant: scenario from torque selector, gain of the torque feedback [V/(lb-in)] and inputs.
Variant = Callable[[str, float, Inputs], Scenario]
#: Longest run [s], and the most sinusoids of the hand's force.
LONGEST, MOST_LINES = 6.0, 4
#: Named on every page.
ABOUT = (
    "Every run follows the line y = 24 in with a controller of the thesis's Table 6: baseline "
    "(impedance control), P (impedance control with torque feedback of 0.16 V/(lb-in)) or velocity "
    "(velocity control with the same feedback). Every variant is run with the nominal inputs and "
    "with {size} sets of plausible inputs. A variant and its reference are compared pair by pair, "
    "with the same inputs; only pairs in which both runs reach the end of the line count."
)


def alike(scenario: Scenario) -> Scenario:
    """The scenario with as many sinusoids as any, so that all are runs of one model."""
    loads = tuple(
        replace(load, lines=load.lines + ((0.0, 1.0, 0.0),) * (MOST_LINES - len(load.lines)))
        if isinstance(load, Operator)
        else load
        for load in scenario.loads
    )
    return scenario.replace(loads=loads, t_end=LONGEST)


def side_by_side(
    variants: Mapping[str, Variant], size: int, controllers: tuple[str, ...] = tuple(CONTROLLERS)
) -> dict[tuple[str, str], Measured]:
    """Measures by (controller, variant): nominal inputs first, then ``size`` drawn ones."""
    inputs = [nominal(), *drawn(size)]
    keys = [(c, v) for c in controllers for v in variants]
    runs = [alike(variants[v](*CONTROLLERS[c], x)) for c, v in keys for x in inputs]
    found = measured(runs)
    count = len(inputs)
    return {key: found.part(slice(k * count, (k + 1) * count)) for k, key in enumerate(keys)}


def pairs(one: Measured, reference: Measured, name: str) -> tuple[float, float]:
    """Median ratio to the reference over drawn inputs, and share of them with less.

    Only inputs with which both runs reach their stop line count.
    """
    both = (one.reached & reference.reached)[1:]
    if not both.any():
        return float("nan"), float("nan")
    a, b = (getattr(m, name)[1:][both] for m in (one, reference))
    return float(np.median(a / b)), float(np.mean(a < b))


def comparison(found: Mapping[tuple[str, str], Measured], reference: str, caption: str) -> Table:
    """Every variant against the reference."""
    rows = []
    for (controller, variant), m in found.items():
        base = found[controller, reference]
        cells = [controller, variant, f"{m.error[0]:.3f}", f"{m.jerk[0]:.0f}", f"{m.stops[0]:.0f}"]
        for name in ("error", "jerk"):
            ratio, share = pairs(m, base, name)
            told = f"{ratio:.2f} ({100 * share:.0f} %)" if ratio == ratio else "none to compare"
            cells.append("" if variant == reference else told)
        rows.append((*cells, f"{m.reached[1:].sum()} of {len(m.reached) - 1}"))
    columns = (
        "controller", "variant", "error / in", "jerk / in/s^3", "stops and breakaways",
        "error ratio (share better)", "jerk ratio (share better)", "reached the end",
    )  # fmt: skip
    return Table(caption, columns, tuple(rows))


def verdict(
    found: Mapping[tuple[str, str], Measured], variant: str, reference: str, name: str
) -> str:
    """In words, controller by controller: how often the variant has less of a measure."""
    parts = []
    for controller in dict.fromkeys(c for c, _ in found):
        ratio, share = pairs(found[controller, variant], found[controller, reference], name)
        told = "no pair of runs that reached the end"
        if ratio == ratio:
            told = f"{100 * share:.0f} % (median ratio {ratio:.2f})"
        parts.append(f"{controller} {told}")
    return ", ".join(parts)


def ratios(found: Mapping[tuple[str, str], Measured], reference: str) -> dict[str, list[float]]:
    """Median ratios and shares behind the table, for files: error, share, jerk, share."""
    return {
        f"{c}, {v}": [
            *pairs(m, found[c, reference], "error"), *pairs(m, found[c, reference], "jerk")
        ]
        for (c, v), m in found.items()
        if v != reference
    }  # fmt: skip


def ratio_picture(found: Mapping[tuple[str, str], Measured], reference: str, title: str):
    """Ratios of error and jerk to the reference: every pair a dot, the median a bar."""
    from matplotlib.lines import Line2D

    from ..plots.style import (
        CLUTCH_COLOURS,
        GREY,
        INK,
        figure,
        legend_beside_title,
        plain_log,
        styled,
    )

    @styled
    def draw():
        variants = [v for v in dict.fromkeys(v for _, v in found) if v != reference]
        controllers = list(dict.fromkeys(c for c, _ in found))
        made = figure(1.4 + 0.5 * len(variants) * len(controllers) ** 0.5, title)
        axes = made.subplots(1, 2, sharey=True)
        for ax, name in zip(axes, ("error", "jerk"), strict=True):
            ax.axvline(1.0, color=GREY, linewidth=0.8)
            for k, controller in enumerate(controllers):
                for j, variant in enumerate(variants):
                    one, base = found[controller, variant], found[controller, reference]
                    both = (one.reached & base.reached)[1:]
                    values = getattr(one, name)[1:][both] / getattr(base, name)[1:][both]
                    y = j + 0.22 * (k - 0.5 * (len(controllers) - 1))
                    dots = {"color": CLUTCH_COLOURS[k], "alpha": 0.45}
                    ax.plot(values, np.full(len(values), y), ".", **dots)
                    if len(values):
                        ax.plot([np.median(values)], [y], "|", color=INK, markersize=12)
            ax.set(xscale="log", xlabel=f"{name}, ratio to: {reference}")
            plain_log(ax.xaxis)
        axes[0].set_yticks(range(len(variants)), variants)
        axes[0].invert_yaxis()
        names = zip(controllers, CLUTCH_COLOURS, strict=False)
        handles = [Line2D([], [], color=colour, ls="", marker=".", label=c) for c, colour in names]
        median = Line2D([], [], color=INK, ls="", marker="|", markersize=12, label="median")
        legend_beside_title(made, [*handles, median])
        return made

    return draw
