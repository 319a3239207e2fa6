"""6.2.2.1, 6.3.2: clutches that sense their torque, sampled at 30, 150 and 1000 Hz."""

from __future__ import annotations

import numpy as np

from ..rigs.inputs import drawn, nominal
from ..rigs.line import line
from .batch import Measured, measured
from .study import Study, Table
from .variants import alike

RATES = (30.0, 150.0, 1000.0)
#: Gains of the torque feedback [V/(lb-in)].
GAINS = (0.0, 0.02, 0.04, 0.08, 0.12, 0.16, 0.2, 0.25, 0.3, 0.4, 0.6)


def torque_sensing(size: int = 24) -> Study:
    """Error and jerk over the gain at three rates, nominal and for plausible inputs."""
    inputs = [nominal(), *drawn(size)]
    keys = [(rate, gain) for rate in RATES for gain in GAINS]
    runs = [
        # The same stages at gain 0, so that all gains are runs of one model.
        alike(line("impedance", max(gain, 1e-9), x.replace(rate=rate)))
        for rate, gain in keys
        for x in inputs
    ]
    every, count = measured(runs), len(inputs)
    found = {key: every.part(slice(k * count, (k + 1) * count)) for k, key in enumerate(keys)}
    best = {rate: best_gains(found, rate) for rate in RATES}
    gained = {
        rate: np.array([reduction(found, rate, k, best[rate][k]) for k in range(1, count)])
        for rate in RATES
    }
    return Study(
        "Clutches that sense their torque: what does the sampling rate buy?",
        "thesis, sections 5.4.3, 6.2.2.1 and 6.3.2 (clutches with torque feedback; a faster "
        "sampling rate)",
        "Every run follows the line y = 24 in with impedance control and proportional torque "
        "feedback; the whole controller runs at one rate. Runs are made with the nominal inputs "
        f"and with {size} sets of plausible inputs, at {len(GAINS)} gains up to {GAINS[-1]:g} "
        "V/(lb-in). Where more clutches stick than are needed to hold the device, the motion does "
        "not tell their torques; then the engine's rule of sharing does. The best gain is the one "
        "with the least average error among those that have no more jerk than without feedback.",
        (gains_by_rate(found, best, gained),),
        sentences(found, best, gained),
        {"gains": list(GAINS), "best": {str(r): b for r, b in best.items()},
         "error": {f"{r:g} {g:g}": float(m.error[0]) for (r, g), m in found.items()},
         "jerk": {f"{r:g} {g:g}": float(m.jerk[0]) for (r, g), m in found.items()}},
        picture(found),
        "Lines: nominal inputs. Bands: from the lower to the upper quartile over plausible inputs.",
    )  # fmt: skip


def best_gains(found: dict[tuple[float, float], Measured], rate: float) -> list[float]:
    """Gain of least error without more jerk than at gain 0, for every set of inputs."""
    calm = found[rate, 0.0].jerk
    errors = np.array([
        np.where(m.reached & (m.jerk <= calm), m.error, np.inf)
        for m in (found[rate, g] for g in GAINS)
    ])  # fmt: skip
    return [GAINS[k] for k in np.argmin(errors, axis=0)]


def reduction(found, rate: float, k: int, gain: float) -> float:
    """Error of one set of inputs at a gain over that without feedback."""
    return float(found[rate, gain].error[k] / found[rate, 0.0].error[k])


def gains_by_rate(found, best, gained) -> Table:
    """What the best gain of every rate does to error and jerk."""
    rows = tuple(
        (f"{rate:g} Hz", f"{best[rate][0]:g}", f"{np.median(best[rate][1:]):g} "
         f"({np.quantile(best[rate][1:], 0.1):g}-{np.quantile(best[rate][1:], 0.9):g})",
         f"{found[rate, 0.0].error[0]:.3f}", f"{found[rate, best[rate][0]].error[0]:.3f}",
         f"{np.median(gained[rate]):.2f}", f"{found[rate, 0.0].jerk[0]:.0f}",
         f"{found[rate, best[rate][0]].jerk[0]:.0f}")
        for rate in RATES
    )  # fmt: skip
    return Table(
        "Best gain by rate",
        ("rate", "best gain, nominal / V/(lb-in)", "best gain, plausible: median (10-90 %)",
         "error at gain 0 / in", "error at the best gain / in",
         "error at best gain / at gain 0, median", "jerk at gain 0 / in/s^3",
         "jerk at the best gain / in/s^3"),
        rows,
    )  # fmt: skip


def sentences(found, best, gained) -> tuple[str, ...]:
    """What the sweep says."""
    slow, thesis, fast = RATES
    lowest = {r: found[r, best[r][0]].error[0] for r in RATES}
    paired = np.array([
        found[fast, best[fast][k]].error[k] < found[thesis, best[thesis][k]].error[k]
        for k in range(1, len(best[fast]))
    ])  # fmt: skip
    return (
        "With feedback at its best gain, this much is left of the error without feedback (median "
        "over the plausible inputs): "
        + ", ".join(f"{100 * np.median(gained[r]):.0f} % at {r:g} Hz" for r in RATES)
        + ".",
        f"With nominal inputs the best gain is {best[slow][0]:g} at {slow:g} Hz, "
        f"{best[thesis][0]:g} at {thesis:g} Hz and {best[fast][0]:g} V/(lb-in) at {fast:g} Hz"
        + (
            ": a faster rate bears more gain, as the thesis expects."
            if best[slow][0] < best[thesis][0] < best[fast][0]
            else "; a faster rate does not always bear more."
        ),
        f"From {thesis:g} to {fast:g} Hz, each at its best gain, the error with nominal inputs "
        f"goes from {lowest[thesis]:.3f} to {lowest[fast]:.3f} in; it falls for "
        f"{100 * paired.mean():.0f} % of the plausible inputs. With nominal inputs and a gain of "
        f"{GAINS[-1]:g}, the jerk is "
        + ", ".join(f"{found[r, GAINS[-1]].jerk[0]:.0f} in/s^3 at {r:g} Hz" for r in RATES)
        + ".",
    )


def picture(found):
    """Error and jerk over the gain."""
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    from ..plots.style import CLUTCH_COLOURS, GREY, figure, legend_beside_title, plain_log, styled

    @styled
    def draw():
        made = figure(6.5, "Torque feedback at three rates")
        for ax, what, unit in zip(
            made.subplots(2, 1, sharex=True), ("error", "jerk"), ("in", "in/s³"), strict=True
        ):
            for rate, colour in zip(RATES, CLUTCH_COLOURS, strict=False):
                rows = np.array([getattr(found[rate, g], what) for g in GAINS])
                low, high = np.quantile(rows[:, 1:], [0.25, 0.75], axis=1)
                ax.fill_between(GAINS, low, high, color=colour, alpha=0.15, linewidth=0.0)
                ax.plot(GAINS, rows[:, 0], "o-", color=colour, markersize=3)
            ax.set(ylabel=f"{what} / {unit}", yscale="log")
            plain_log(ax.yaxis)
        ax.set_xlabel("gain / V/(lb-in)")
        handles = [
            Line2D([], [], color=colour, marker="o", markersize=3, label=f"{rate:g} Hz")
            for rate, colour in zip(RATES, CLUTCH_COLOURS, strict=False)
        ]
        line = Line2D([], [], color=GREY, label="nominal inputs")
        band = Patch(facecolor=GREY, alpha=0.3, label="quartiles of plausible inputs")
        legend_beside_title(made, [*handles, line, band])
        return made

    return draw
