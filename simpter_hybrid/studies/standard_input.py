"""6.3.2: a standard force input that robot and simulation can both be given."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np

from ..devices.pter_equations import inverse_kinematics
from ..known_units import INCH, LBF
from ..loads.operator import Operator
from ..loads.recorded import RecordedTipForce
from ..reproduce.standard import CONTROLLERS
from ..rigs.inputs import nominal
from ..rigs.line import line
from ..scenario import Scenario
from .batch import Measured, measured
from .study import Study, Table
from .variants import alike

#: Force along the path, and largest force across it [N].
PUSH, ACROSS = 7.0 * LBF, 5.0 * LBF
#: What one repeat differs by from another (standard deviations): force, relative; start [m]; [s].
FORCE, START, TIMING = 0.02, 2e-3, 0.02
THESIS = "the thesis's, inferred"
#: Sinusoids across the path: share of ACROSS, Hz, phase at the start [rad].
WAVES = {
    "push alone": (),
    "one sinusoid, 0.5 Hz": ((1.0, 0.5, 0.0),),
    "one sinusoid, 1 Hz": ((1.0, 1.0, 0.0),),
    "two sinusoids, 0.5 and 1.3 Hz": ((0.5, 0.5, 0.0), (0.5, 1.3, 0.0)),
}
STEPS = "steps every 0.5 s"
#: A period of the steps: instants [s], counted from half a ramp before 0, and shares of ACROSS.
CORNERS = ((0.0, 0.05, 0.5, 0.55, 1.0), (-1.0, 1.0, 1.0, -1.0, -1.0))


def pushed(inputs_name: str, draws: np.ndarray) -> tuple:
    """The load of one repeat; ``draws`` (4,) are standard normal: force, start x, y, timing."""
    size, late = 1.0 + FORCE * draws[0], TIMING * draws[3]
    if inputs_name == STEPS:
        times = 0.025 * np.arange(241)
        wave = np.interp((times - late + 0.025) % 1.0, *CORNERS)
        points = tuple(
            (float(t), -PUSH * size, float(ACROSS * size * w))
            for t, w in zip(times, wave, strict=True)
        )
        return (RecordedTipForce(points),)
    if inputs_name == THESIS:
        its = line().loads[0]
        assert isinstance(its, Operator)
        lines = its.lines
    else:
        # Across is +90 degrees from the push, which is -y: minus for a force that starts upwards.
        lines = tuple((-ACROSS * a, f, phase) for a, f, phase in WAVES[inputs_name])
    shifted = tuple((size * a, f, ph - 2.0 * math.pi * f * late) for a, f, ph in lines)
    return (Operator(PUSH * size, math.pi, shifted),)


def repeat(controller: str, inputs_name: str, draws: np.ndarray) -> Scenario:
    """One run of a controller as a person would repeat it on the robot."""
    x = nominal()
    scenario = line(*CONTROLLERS[controller])
    q = [0.0, 0.0]
    at = (3 * INCH + START * draws[1], x.line_y + START * draws[2])
    inverse_kinematics(*at, 1, [0.0, 0.0, 0.0, x.l_a, x.l_d], q)
    return alike(scenario.replace(loads=pushed(inputs_name, draws), q=tuple(q)))


def standard_input(size: int = 24) -> Study:
    """Which force tells controllers apart in the fewest repeats, and its file."""
    names = (THESIS, *WAVES, STEPS)
    draws = np.vstack([np.zeros(4), np.random.default_rng(63).standard_normal((size, 4))])
    keys = [(n, c) for n in names for c in CONTROLLERS]
    every, count = measured([repeat(c, n, d) for n, c in keys for d in draws]), len(draws)
    found = {key: every.part(slice(k * count, (k + 1) * count)) for k, key in enumerate(keys)}
    told = {n: {what: distinctness(found, n, what) for what in ("error", "jerk")} for n in names}
    weakest = {n: min(min(v) for v in told[n].values()) for n in names}
    chosen, second = sorted(weakest, key=lambda n: -weakest[n])[:2]
    return Study(
        "A standard force input: which one can robot and simulation share?",
        "thesis, section 6.3.2 (a standard force input is needed to compare them)",
        f"Every force has a constant {PUSH / LBF:g} lbf along the path and at most "
        f"{ACROSS / LBF:g} lbf across it. Every controller is given it {size} times, each time "
        "with the small differences that no rig can avoid (standard deviations): "
        f"{100 * FORCE:g} % of the force, {1e3 * START:g} mm of the start in x and y, and "
        f"{1e3 * TIMING:g} ms of the timing. A force is the better, the further apart the "
        "controllers' results lie, in units of their scatter: (difference of means)/(rms standard "
        "deviation).",
        (
            table_of(found, names, told, size),
        ),
        (
            "For each force, take the two controllers and the measure that it tells apart worst. "
            f"By this, the best force is: {chosen} ({weakest[chosen]:.1f} standard deviations; the "
            f"thesis's inferred force has {weakest[THESIS]:.1f}). The next is: {second} "
            f"({weakest[second]:.1f}).",
            "Number of repeats with each controller that are needed to tell both pairs of "
            "controllers apart by error and by jerk (confidence 95 %, power 90 %): "
            + "; ".join(f"{n}: {repeats(weakest[n])}" for n in names) + ".",
            rankings(found, chosen),
            "The file standard-input.csv holds the chosen force as a table of time and force, "
            "which a rig and the load recorded-tip-force can play.",
        ),
        {"distinctness": told, "chosen": chosen},
        picture(found, names),
        "Every dot is one repeat.",
        {"standard-input.csv": force_file(chosen)},
    )  # fmt: skip


def rankings(found: dict[tuple[str, str], Measured], chosen: str) -> str:
    """How the chosen force and the thesis's rank the controllers, in a sentence."""
    its, theirs = (
        " < ".join(sorted(CONTROLLERS, key=lambda c: found[force, c].error[1:].mean()))
        for force in (chosen, THESIS)
    )
    words = f"By error the controllers rank {its} with the chosen force"
    if its == theirs:
        return f"{words}, and with the thesis's alike."
    return f"{words}, but {theirs} with the thesis's: a ranking belongs to its force."


def table_of(found, names, told, size: int) -> Table:
    """Errors and distinctions by force."""
    rows = tuple(
        (n, *(f"{found[n, c].error[0]:.3f} +- {found[n, c].error[1:].std(ddof=1):.3f}"
              for c in CONTROLLERS),
         *(f"{v:.1f}" for what in ("error", "jerk") for v in told[n][what]),
         f"{sum(found[n, c].reached[1:].sum() for c in CONTROLLERS)} of {3 * size}")
        for n in names
    )  # fmt: skip
    columns = (
        "force", *CONTROLLERS, "error: baseline-P", "P-velocity", "jerk: baseline-P", "P-velocity",
        "reached the end",
    )  # fmt: skip
    return Table(
        "Error by controller: with the exact input +- scatter of the repeats [in]; then how far "
        "neighbouring controllers lie apart [standard deviations]",
        columns,
        rows,
    )


def distinctness(found: dict[tuple[str, str], Measured], force: str, what: str) -> list[float]:
    """Difference of neighbouring controllers over their rms scatter, between repeats."""
    its = [getattr(found[force, c], what)[1:] for c in CONTROLLERS]
    return [
        float(abs(a.mean() - b.mean()) / math.sqrt(0.5 * (a.var(ddof=1) + b.var(ddof=1))))
        for a, b in pairwise(its)
    ]


def repeats(apart: float) -> int:
    """Repeats a controller that tell means ``apart`` standard deviations apart (normal theory)."""
    return max(2, math.ceil(2.0 * ((1.960 + 1.282) / apart) ** 2))


def force_file(force: str) -> str:
    """The force as a file: the points it was run with, or 20 ms steps of one that has a formula.

    The load recorded-tip-force curves through its points: between other ones than those that were
    run it would be another force.
    """
    exact = np.zeros(4)
    (load,) = pushed(force, exact)
    points = load.points if isinstance(load, RecordedTipForce) else sampled(load)
    rows = (",".join(f"{value:.12g}" for value in point) for point in points)
    return "\n".join(("time [s],x force [N],y force [N]", *rows)) + "\n"


def sampled(load: Operator) -> list[tuple[float, float, float]]:
    """Instants [s] in 20 ms steps, and forces along x and y [N]."""
    points, p = [], [0.0, *load.table()]
    for t in np.arange(0.0, 6.0001, 0.02):
        out = [0.0, 0.0]
        load.tip_force(float(t), p, 1, load.along, load.angle, out)
        points.append((float(t), out[0], out[1]))
    return points


def picture(found: dict[tuple[str, str], Measured], names: tuple[str, ...]):
    """Error against jerk of every repeat, force by force."""
    from matplotlib.lines import Line2D

    from ..plots.style import CLUTCH_COLOURS, figure, legend_beside_title, plain_log, styled

    @styled
    def draw():
        made = figure(5.7, "Repeats of the same test, by force")
        axes = made.subplots(2, 3, sharex=True, sharey=True)
        for ax, name in zip(axes.flat, names, strict=True):
            for controller, colour in zip(CONTROLLERS, CLUTCH_COLOURS, strict=False):
                m = found[name, controller]
                ax.plot(m.error, m.jerk, ".", color=colour)
            ax.set(title=name, xscale="log", yscale="log")
        plain_log(ax.xaxis)
        plain_log(ax.yaxis)
        for ax in axes[-1]:
            ax.set_xlabel("error / in")
        for ax in axes[:, 0]:
            ax.set_ylabel("jerk / in/s³")
        names_of = zip(CONTROLLERS, CLUTCH_COLOURS, strict=False)
        dots = [Line2D([], [], color=colour, ls="", marker=".", label=c) for c, colour in names_of]
        legend_beside_title(made, dots)
        return made

    return draw
