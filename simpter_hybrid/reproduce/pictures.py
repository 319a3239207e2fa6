"""Pictures of the page: drawn from the runs that the comparisons have made and kept."""

from __future__ import annotations

import numpy as np

from ..known_units import INCH
from ..laws import LBF_IN
from ..measuring.sampling import sample
from .found_by_exact import sweeps
from .found_pictures import counts
from .gain_sweep import GAINS
from .measured import picture as measured
from .regulation import RUNS, figure_50
from .rows import Engine
from .sampled_loop import border
from .standard import CONTROLLERS, standard
from .tracking import tracked


def pictures(names: list[str], engine: Engine) -> dict[str, tuple[str, bytes]]:
    """Caption and PNG by name of comparison, for those of ``names`` that have a picture."""
    from ..plots.style import png, styled

    drawn = {}
    for name, (caption, draw) in PICTURES.items():
        if name in names:
            drawn[name] = (caption, png(styled(draw)(engine)))
    return drawn


def regulation(engine: Engine):
    """Figure 50 and the border of stability."""
    from ..plots.style import BLUE, GREY, ORANGE, figure

    made = figure(8.0, "Regulating 150 lb-in while 250 lb-in push")
    axes = made.subplot_mosaic([["a", "b"], ["c", "d"], ["border", "border"]])
    for key, (gain, rate) in zip("abcd", RUNS, strict=True):
        ax = axes[key]
        trajectory = figure_50(engine, gain, rate)
        t = np.linspace(0.0, trajectory.t_end, 1001)
        ax.plot(t, np.abs(sample(trajectory, t).tau[:, 0]) / LBF_IN, color=BLUE)
        ax.axhline(150.0, color=GREY, linewidth=0.8)
        ax.set(title=f"{rate:g} Hz, gain {gain:g}", ylim=(0, 260), xlabel="t / s", ylabel="lb-in")
    below = axes["border"]
    rates = np.geomspace(15.0, 300.0, 60)
    below.plot(rates, [border(r) for r in rates], color=BLUE, label="lag and hold")
    low = rates[rates < 75.0]
    late = [border(r, dead_time=0.012) for r in low]
    below.plot(low, late, color=ORANGE, linestyle="--", label="and 12 ms of dead time")
    for gain, rate in RUNS[1:]:
        below.plot(rate, gain, "o", color=GREY)
    below.set(xscale="log", yscale="log", xlabel="controller rate / Hz", ylabel="gain / V/(lb-in)")
    below.set_xticks([15, 30, 60, 150, 300], ["15", "30", "60", "150", "300"])
    below.set_yticks([0.05, 0.08, 0.2, 0.5], ["0.05", "0.08", "0.2", "0.5"])
    below.minorticks_off()
    below.set_title("Border of stability at 150 lb-in (unstable above); dots: Figure 50")
    below.legend()
    return made


def tracking(engine: Engine):
    """Figures 48 and 49, without and with dead time."""
    from ..plots.style import BLUE, GREY, ORANGE, figure

    made = figure(5.5, "Following a sinusoid at 30 Hz")
    for ax, dead in zip(made.subplots(2, 1, sharex=True), (0.0, 0.012), strict=True):
        for gain, colour in ((0.08, BLUE), (0.20, ORANGE)):
            trajectory = tracked(engine, gain, dead)
            t = np.linspace(0.0, trajectory.t_end, 4001)
            found = sample(trajectory, t)
            torque = np.abs(found.tau[:, 0]) / LBF_IN
            ax.plot(t, torque, color=colour, linewidth=0.9, label=f"gain {gain:g}")
        ax.plot(t, found.held["desired_1"] / LBF_IN, color=GREY, label="desired")
        ax.set(ylabel="lb-in", title="no dead time" if dead == 0.0 else "12 ms of dead time")
    ax.set_xlabel("t / s")
    ax.legend(loc="upper right")
    return made


def tables(engine: Engine):
    """Paths of the three controllers (Figures 37, 45, 54)."""
    from ..plots.style import CLUTCH_COLOURS, GREY, figure

    made = figure(4.0, "Tip paths of the three controllers")
    ax = made.subplots()
    for name, colour in zip(CONTROLLERS, CLUTCH_COLOURS, strict=False):
        trajectory = standard(engine, name)
        tip = sample(trajectory, np.linspace(0.0, trajectory.t_end, 1500)).tip / INCH
        ax.plot(tip[:, 0], tip[:, 1], color=colour, label=name)
    ax.axhline(24.0, color=GREY, linewidth=0.8)
    ax.set(xlabel="x / in", ylabel="y / in")
    ax.legend()
    return made


def gain_sweep(engine: Engine):
    """Figures 43 and 44, exact and with bands."""
    from ..plots.style import CLUTCH_COLOURS, figure

    made = figure(6.5, "Error and jerk over the feedback gain")
    upper, lower = made.subplots(2, 1, sharex=True)
    for (name, (error, jerk)), colour in zip(sweeps(engine).items(), CLUTCH_COLOURS, strict=False):
        thick = 2.2 if name == "exact" else 0.9
        upper.plot(GAINS, error, ".-", color=colour, linewidth=thick, label=name)
        lower.plot(GAINS, jerk, ".-", color=colour, linewidth=thick)
    upper.set_ylabel("average error / in")
    lower.set(xlabel="gain / V/(lb-in)", ylabel="average jerk / in/s^3 (5 ms)")
    upper.legend()
    return made


PICTURES = {
    "measured": ("The printed measurements against the clutch model and corrected.", measured),
    "regulation": (
        "Figure 50 rebuilt, and where the sampled torque loop loses stability.",
        regulation,
    ),
    "tracking": ("Figures 48 and 49 rebuilt: the dead time decides what gain is stable.", tracking),
    "tables": ("Figures 37, 45 and 54 in one.", tables),
    "gain-sweep": ("Figures 43 and 44: the scatter hangs on the friction model.", gain_sweep),
    "found-by-exact": ("The same two runs, counted by five simulators.", counts),
}
