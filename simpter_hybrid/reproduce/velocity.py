"""Figures 51-55: the velocity controller."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from ..controllers.tip_forces import opposing_force
from ..devices.pter_equations import clutch_map, tip_jacobian
from ..known_units import INCH
from ..measuring.metrics import measures, time_weighted_average
from ..measuring.sampling import sample
from ..rigs.inputs import drawn, nominal
from ..trajectory import Trajectory
from .rows import Engine, Row, claim, uncomparable
from .sensitivity import hanging
from .standard import plausible, run, standard, table

#: State of Figure 53; printed with negative link angles, but its tip position needs these.
Q, QD = (math.pi / 4, math.pi / 3), (-2.1, 0.8)


def velocity(engine: Engine, draws: int = 64) -> list[Row]:
    """Figure 53, Figures 54 and 55, and the step the thesis proposes next."""
    return [*figure_53(), heading(), *figures(engine, draws), *gradual(engine), gomes(engine)]


def figure_53() -> list[Row]:
    """Four force directions at one state."""
    x = nominal()
    jacobian, unit, slips = [0.0] * 4, [0.0] * 2, [0.0] * 8
    tip_jacobian(Q, (0.0, 0.0, 0.0, x.l_a, x.l_d), jacobian)
    clutch_map(Q, (), slips)
    move = np.reshape(jacobian, (2, 2)) @ QD
    angles, powers = [], []
    for i in range(4):
        opposing_force(i, QD, jacobian, slips, unit)
        angles.append(math.degrees(math.atan2(unit[1], unit[0])))
        powers.append(float(move @ unit))
    tip = (
        (x.l_a * math.cos(Q[0]) - x.l_d * math.sin(Q[1])) / INCH,
        (x.l_a * math.sin(Q[0]) + x.l_d * math.cos(Q[1])) / INCH,
    )
    printed = (
        (x.l_a * math.cos(-Q[0]) - x.l_d * math.sin(-Q[1])) / INCH,
        (x.l_a * math.sin(-Q[0]) + x.l_d * math.cos(-Q[1])) / INCH,
    )
    text = ", ".join(f"{a:.0f}" for a in angles)
    return [
        claim(
            "A44",
            "Figure 53: all four clutch forces slow the tip",
            "all",
            f"directions {text} deg against a velocity at "
            f"{math.degrees(math.atan2(move[1], move[0])):.0f} deg; every power negative",
            max(powers) < 0.0,
            directions=angles,
        ),
        claim(
            "A44",
            "the state printed for Figure 53 is the one drawn",
            "(-pi/4, -pi/3), tip in 3.8-5.8 by 36.8-38.8 in",
            f"(pi/4, pi/3) puts the tip at {tip[0]:.2f}, {tip[1]:.2f} in; the printed signs put it "
            f"at {printed[0]:.1f}, {printed[1]:.1f} in",
            inside(*printed),
            why="signs lost in the text; the lengths are inferred from this very figure",
        ),
    ]


def inside(x: float, y: float) -> bool:
    """Whether a point lies in the window of Figure 53 [in]."""
    return 3.8 < x < 5.8 and 36.8 < y < 38.8


def heading() -> Row:
    """Equations (47) and (48) as printed and as the text means them."""
    return claim(
        "A43",
        "(48) keeps the desired velocity within 45 degrees of the path",
        "45 deg",
        f"at |d| = 0.9 K_v (47) gives {math.degrees(math.asin(0.9)):.0f} deg and (48), which sets "
        "in "
        "at K_v only, leaves it",
        math.asin(0.9) <= 0.25 * math.pi,
        why="the limit is applied to the angle here; in the standard run |d| never exceeds 0.71 "
        "K_v "
        "and the two agree",
    )


class Accelerated(NamedTuple):
    """Size of a tip's acceleration [in/s^2]; `travel`: how far it goes up and down in a second."""

    high: float
    mean: float
    travel: float


def accelerated(trajectory: Trajectory) -> Accelerated:
    """How the tip is accelerated in a run, looked at every millisecond."""
    found = sample(trajectory, np.arange(int(trajectory.t_end / 1e-3)) * 1e-3)
    size = np.linalg.norm(found.tip_acceleration, axis=1) / INCH
    travel = float(np.abs(np.diff(size)).sum() / trajectory.t_end)
    return Accelerated(float(size.max()), time_weighted_average(found.t, size), travel)


def figures(engine: Engine, draws: int) -> list[Row]:
    """Tip and acceleration against impedance control with the same feedback."""
    nominal_runs = table(engine)
    runs = zip(drawn(draws), plausible(engine, draws), strict=True)
    pairs = [(x, r) for x, r in runs if all(b.finished for b in r.values())]
    every = [r for _, r in pairs]
    lower = [r["P"].average_acceleration / r["velocity"].average_acceleration - 1 for r in every]
    better = float(np.mean([r["velocity"].average_error < r["P"].average_error for r in every]))
    p, own = (accelerated(standard(engine, name)) for name in ("P", "velocity"))
    return [
        claim(
            "A45",
            "Figure 54: velocity control follows the path better than impedance control",
            "0.067 against 0.132 in",
            f"{nominal_runs['velocity'].average_error / INCH:.3f} against "
            f"{nominal_runs['P'].average_error / INCH:.3f} in; better for {100 * better:.0f} % of "
            f"{len(every)} plausible inputs",
            nominal_runs["velocity"].average_error < nominal_runs["P"].average_error,
            share=better,
        ),
        claim(
            "A45",
            "Figure 55: both accelerations stay below 80 in/s^2",
            "axis 0-80",
            f"{p.high:.0f} and {own.high:.0f} in/s^2",
            max(p.high, own.high) < 80.0,
        ),
        claim(
            "A45",
            "velocity control exerts lower overall forces (acceleration)",
            "15.77 against 17.58 in/s^2",
            f"{own.mean:.1f} against {p.mean:.1f} in/s^2; lower for "
            f"{100 * np.mean(np.array(lower) > 0.0):.0f} % of {len(every)} plausible inputs",
            own.mean < p.mean,
            share=float(np.mean(np.array(lower) > 0.0)),
            why="the lock-up fallback and every newly chosen clutch step the torque; "
            + hanging([x for x, _ in pairs], lower),
        ),
        claim(
            "A45",
            "its acceleration oscillates more, which is its lack of smoothness",
            "higher oscillation",
            f"acceleration's size travels {own.travel:.0f} against {p.travel:.0f} in/s^2 per "
            "second",
            own.travel > p.travel,
        ),
    ]


def gradual(engine: Engine) -> list[Row]:
    """S34, S61: the velocity controller with gradual application and release."""
    found = {}
    for fade in (None, 0.01, 0.02, 0.05, 0.1):
        trajectory = run(engine, "velocity", 0.16, fade=fade)
        m = measures(trajectory, 2e-3)
        found[fade] = (
            m.average_error / INCH,
            (m.variation_smooth + m.variation_jumps) / INCH,
            trajectory.t_end,
        )
    text = "; ".join(
        f"{'step' if f is None else f'{1e3 * f:.0f} ms'}: error {e:.3f} in, variation {v:.0f} "
        "in/s^3, "
        f"{t:.2f} s"
        for f, (e, v, t) in found.items()
    )
    step, faded = found[None], [found[f] for f in (0.01, 0.02, 0.05, 0.1)]
    return [
        claim(
            "S34 S61",
            "gradual application and release makes velocity control smoother",
            "should be an associated decrease in jerk",
            text,
            min(v for _, v, _ in faded) < step[1],
            why="a delay in a loop that chooses one clutch at a time: it overshoots and works "
            "harder",
        ),
        claim(
            "S34 S61",
            "and deteriorates its tracking",
            "likely",
            f"error {step[0]:.3f} in with steps, {min(e for e, _, _ in faded):.3f} to "
            f"{max(e for e, _, _ in faded):.3f} in with fades",
            max(e for e, _, _ in faded) > step[0],
        ),
    ]


def gomes(engine: Engine) -> Row:
    """S30: the fixed 45 degrees of the first velocity controller."""
    ours = measures(run(engine, "velocity", 0.16), 2e-3)
    fixed = measures(run(engine, "gomes-velocity", 0.16), 2e-3)
    return uncomparable(
        "S30 A43",
        "Gomes's velocity controller (45 degrees) against the thesis's",
        "not compared",
        f"error {fixed.average_error / INCH:.3f} against {ours.average_error / INCH:.3f} in, "
        "variation "
        f"{(fixed.variation_smooth + fixed.variation_jumps) / INCH:.0f} against "
        f"{(ours.variation_smooth + ours.variation_jumps) / INCH:.0f} in/s^3",
        "how Gomes got torques from the heading is not printed; the thesis's (53) was taken",
    )
