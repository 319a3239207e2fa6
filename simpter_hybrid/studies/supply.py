"""6.3.2, 4.6.1: a supply with more voltage, and one in its fast mode."""

from __future__ import annotations

import numpy as np

from ..compiled import simulate
from ..effects.coil_supply import CoilSupply
from ..effects.command_scale import CommandScale
from ..laws import LBF_IN
from ..measuring.sampling import sample
from ..rigs.inputs import Inputs
from ..rigs.line import line
from ..rigs.testbed import step
from ..scenario import Scenario
from .study import Study, Table
from .variants import ABOUT, comparison, ratio_picture, ratios, side_by_side, verdict

#: Name -> most voltage [V in command volts], gain of the current loop, steady error.
SUPPLIES = {
    "as measured": (15.0, 20.0, 0.0),
    "at full scale only": (10.0, 20.0, 0.0),
    "twice the voltage": (30.0, 20.0, 0.0),
    "four times": (60.0, 20.0, 0.0),
    "slow loop": (15.0, 3.0, 0.0),
    "fast mode": (15.0, 100.0, -0.05),
    "fast mode, twice": (30.0, 100.0, -0.05),
}
NOW, STRONG = "as measured", "four times"
#: Marks a variant whose torque feedback has half the gain: a faster clutch bears less.
HALVED = ", gain halved"


def effects(clutch: int, supply: tuple[float, float, float]) -> tuple:
    """Coil and supply of a clutch."""
    clamp, stiffness, error = supply
    return (
        CommandScale(clutch=clutch, gain=error),
        CoilSupply(clutch=clutch, clamp=clamp, stiffness=stiffness),
    )


def supplied(kind: str, gain: float, x: Inputs, name: str) -> Scenario:
    """The line with a supply behind every clutch instead of the lag."""
    which = SUPPLIES[name.removesuffix(HALVED)]
    scenario = line(kind, 0.5 * gain if name.endswith(HALVED) else gain, x)
    return scenario.replace(effects=tuple(e for i in range(4) for e in effects(i, which)))


def rise(volts: float, which: tuple[float, float, float]) -> tuple[float, float]:
    """Time to 63 % of the torque's step [s], and its steady error [lb-in], from rest."""
    run = simulate(step(0.0, volts).replace(effects=effects(0, which)))
    exact = simulate(step(0.0, volts).replace(effects=effects(0, SUPPLIES[NOW])))
    t = np.linspace(2.0, 3.0, 10001)
    torque = np.abs(sample(run, t).tau[:, 0])
    target = torque[0] + (1.0 - np.exp(-1.0)) * (torque[-1] - torque[0])
    off = torque[-1] - np.abs(sample(exact, t[-1:]).tau[0, 0])
    return float(t[np.argmax(torque >= target)] - 2.0), float(off) / LBF_IN


def step_table(steps: dict[str, dict[float, tuple[float, float]]]) -> Table:
    """Steps of one clutch by supply."""
    return Table(
        "Step of a testbed clutch from 0 V: time until the torque has made 63 % of its step, with "
        "dead time and closing of the gap included",
        ("supply", "voltage limit / full scale", "loop gain", "to 3 V / ms", "to 8 V / ms",
         "steady error at 8 V / lb-in"),
        tuple(
            (name, f"{w[0] / 10.0:g}", f"{w[1]:g}", f"{1e3 * steps[name][3.0][0]:.0f}",
             f"{1e3 * steps[name][8.0][0]:.0f}", f"{round(steps[name][8.0][1], 1) + 0.0:.1f}")
            for name, w in SUPPLIES.items()
        ),
    )  # fmt: skip


def supply(size: int = 24) -> Study:
    """Steps of the testbed, and the line, over voltage and loop gain of the supply."""
    variants = {
        name: lambda kind, gain, x, its=name: supplied(kind, gain, x, its)
        for name in (*SUPPLIES, STRONG + HALVED)
    }
    found = side_by_side(variants, size)
    steps = {name: {v: rise(v, w) for v in (3.0, 8.0)} for name, w in SUPPLIES.items()}
    now, strong = (steps[name][8.0][0] for name in (NOW, STRONG))
    return Study(
        "A stronger supply and the supply's fast mode: a faster clutch, and a better device?",
        "thesis, sections 4.6.1 and 6.3.2; the measured supply is inferred from the steps in "
        "Figures 17-23, and what the fast mode changes is not printed",
        ABOUT.format(size=size) + " In place of the thesis's lag, every clutch has a coil with a "
        "time constant of 0.124 s on a supply that controls the current and has a limited voltage "
        "(effects.coil_supply). The fast mode is modelled as a current loop that is five times "
        "stiffer and 5 % off in the steady state.",
        (
            step_table(steps),
            comparison(found, NOW, "On the line"),
        ),
        (
            f"Four times the voltage shortens the 8 V step from {1e3 * now:.0f} to "
            f"{1e3 * strong:.0f} ms; the dead time and the closing of the gap (21 ms) remain.",
            "On the line, four times the voltage means less error for these shares of the "
            f"plausible inputs: {verdict(found, STRONG, NOW, 'error')}. It means less jerk for "
            f"these: {verdict(found, STRONG, NOW, 'jerk')}.",
            "If the gain of the torque feedback is halved as well, there is less error for these "
            f"shares: {verdict(found, STRONG + HALVED, NOW, 'error')}. There is less jerk for "
            f"these: {verdict(found, STRONG + HALVED, NOW, 'jerk')}. (The baseline has no "
            "feedback.)",
            "The fast mode without more voltage means less error for these shares: "
            f"{verdict(found, 'fast mode', NOW, 'error')}. A stiffer loop cannot go faster than "
            "the limited voltage lets it; it only completes the approach sooner.",
        ),
        {"ratios": ratios(found, NOW), "steps": {k: {str(v): r for v, r in row.items()}
                                                 for k, row in steps.items()}},
        ratio_picture(found, NOW, "Supplies, against the one measured"),
        "Each dot is one set of plausible inputs; bars are medians.",
    )  # fmt: skip
