"""Pictures of what the band hides or invents."""

from __future__ import annotations

import numpy as np

from ..measuring.sampling import sample
from ..rigs.line import line
from .found_by_exact import COUNTED, PRINTED, sweeps
from .found_causes import BANDS, RATES, banded, counted, exactly, pace
from .gain_sweep import GAINS
from .rows import Engine
from .sampled_loop import border

#: Gains of the comparison of rates.
PACED = GAINS[::2]


def scatter(engine: Engine):
    """Error and jerk over the gain, exact and with bands; jerk and alternation at two rates."""
    from ..plots.style import CLUTCH_COLOURS, GREY, INK, figure

    made = figure(9.0, "Error and jerk over the feedback gain")
    error, jerk, rates = made.subplots(3, 1, sharex=True)
    for (name, (e, j)), colour in zip(sweeps(engine).items(), CLUTCH_COLOURS, strict=False):
        thick = 2.4 if name == "exact" else 0.9
        order = 3 if name == "exact" else 2
        error.plot(GAINS, e, ".-", color=colour, linewidth=thick, label=name, zorder=order)
        jerk.plot(GAINS, j, ".-", color=colour, linewidth=thick, zorder=order)
    error.set(ylabel="average error / in", ylim=(0.0, None))
    jerk.set(ylabel="average jerk / in/s^3", ylim=(0.0, 700.0))
    error.legend(ncols=2)
    for rate, colour in zip(RATES, (CLUTCH_COLOURS[0], INK), strict=True):
        found = [pace(engine, g, rate).jerk for g in PACED]
        rates.plot(PACED, found, ".-", color=colour, label=f"exact, controller at {rate:g} Hz")
    low, high = (border(RATES[0], wanted=w) for w in (200.0, 100.0))
    rates.axvspan(low, high, color=GREY, alpha=0.25, linewidth=0.0)
    rates.text(0.5 * (low + high), 20.0, "border of the loop at 150 Hz,\n200 to 100 lb-in",
               ha="center", fontsize=8)  # fmt: skip
    rates.set(ylabel="average jerk / in/s^3", ylim=(0.0, None), xlabel="gain / V/(lb-in)")
    rates.legend(loc="upper left")
    return made


def counts(engine: Engine):
    """Transitions counted over the band."""
    from ..plots.style import CLUTCH_COLOURS, figure

    made = figure(5.0, "Transitions counted in one and the same run")
    axes = made.subplots(1, 2, sharey=True)
    for ax, (gain, printed) in zip(axes, PRINTED, strict=True):
        found = exactly(engine, gain).transitions
        ax.axhline(found, color=CLUTCH_COLOURS[0], linewidth=2.4, label="exact, no band")
        for (rules, rtol), colour, mark in zip(COUNTED, CLUTCH_COLOURS[1:], "osov", strict=False):
            numbers = [counted(rules, band, rtol, gain).transitions for band in BANDS]
            label = f"Karnopp, {rules} rules, rtol {rtol:g}"
            style = "--" if rtol == COUNTED[0][1] else "-"
            ax.plot(BANDS, numbers, mark + style, color=colour, label=label, markersize=5)
        ax.set(xscale="log", yscale="log", xlabel="band / rad/s")
        ax.set_title(f"gain {gain:g}: exact {found}, thesis {printed}")
        ax.set_yticks([1, 2, 5, 10, 50, 200, 800], ["1", "2", "5", "10", "50", "200", "800"])
        ax.minorticks_off()
        ax.set_ylim(0.8, 1000)
    axes[0].set_ylabel("transitions")
    axes[1].legend(fontsize=8, loc="upper left")
    return made


def slips(engine: Engine):
    """Slip velocity of clutch 3 without feedback, by three simulators."""
    from ..plots.style import CLUTCH_COLOURS, GREY, figure

    made = figure(5.5, "Slip velocity of clutch 3, gain 0")
    cases = (
        ("exact", engine),
        ("Karnopp, fair rules, 0.01 rad/s", banded("fair", 1e-2)),
        ("Karnopp, thesis rules, 0.001 rad/s", banded("thesis", 1e-3)),
    )
    axes = made.subplots(3, 1, sharex=True, sharey=True)
    for ax, (name, its), colour in zip(axes, cases, CLUTCH_COLOURS, strict=False):
        run = its(line(gain=0.0))
        end = min(run.t_end, 2.6)
        t = np.linspace(0.0, end, 2601)
        ax.axhline(0.0, color=GREY, linewidth=0.8)
        slip = sample(run, t).slip[:, 2]
        ax.plot(t, slip, color=colour)
        rest = np.ma.masked_where(run.mode[[run.segment_at(x) for x in t], 2] != 0, slip)
        ax.plot(t, rest, color="black", linewidth=4)
        ax.set(ylabel="rad/s", title=f"{name} (black: stuck)")
    axes[-1].set_xlabel("t / s")
    return made
