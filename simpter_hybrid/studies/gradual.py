"""6.2.2.2, 6.3.1: the velocity controller with gradual application and release of clutches."""

from __future__ import annotations

from ..controllers.blending import Blending
from ..rigs.line import line
from .study import Study
from .variants import ABOUT, comparison, pairs, ratio_picture, ratios, side_by_side, verdict

#: Time to apply and to release [s].
FADES = (
    (0.01, 0.01), (0.02, 0.02), (0.05, 0.05), (0.1, 0.1), (0.05, 0.0), (0.0, 0.05),
)  # fmt: skip
STEP = "steps"


def name_of(apply: float, release: float) -> str:
    """Words for a pair of times."""
    if apply == release:
        return f"{1e3 * apply:g} ms"
    return f"apply {1e3 * apply:g}, release {1e3 * release:g} ms"


def gradual(size: int = 24) -> Study:
    """Fades from 10 to 100 ms, both ways and one way only, against steps."""

    def variant(fade):
        def build(kind, gain, x):
            scenario = line(kind, gain, x)
            (selector, k), *others = scenario.controllers
            return scenario.replace(controllers=((selector, k), (Blending(*fade), k), *others))

        return build

    variants = {STEP: line_as_is} | {name_of(*fade): variant(fade) for fade in FADES}
    found = side_by_side(variants, size, ("velocity",))
    both = [name_of(*fade) for fade in FADES if fade[0] == fade[1]]
    steps = found["velocity", STEP]
    smoother = {v: pairs(found["velocity", v], steps, "jerk") for v in variants if v != STEP}
    # A share of pairs says little where many runs of one side never arrive.
    arriving = [v for v in smoother if found["velocity", v].reached.mean() > 0.8]
    best = min(arriving or smoother, key=lambda v: smoother[v][0])
    worse = {v: pairs(found["velocity", v], steps, "error")[0] for v in both}
    trend = "grows" if worse[both[-1]] > max(worse[both[0]], 1.0) else "does not grow"
    return Study(
        "Velocity control with gradual application and release: smoother, and at what price?",
        "thesis, sections 6.2.2.2 and 6.3.1, which do not print how long a fade would take",
        ABOUT.format(size=size) + " Between the torque selector and the lookup table every clutch "
        "is given a weight that rises and falls linearly (controllers.blending). This is the fade; "
        "the times are how long it takes. A fade that is shorter than one sample of 6.7 ms is a "
        "step.",
        (comparison(found, STEP, "Velocity controller, 150 Hz"),),
        (
            "Of the fades with which more than four fifths of the runs reach the end, this one has "
            f"the least jerk: {best}. Compared with steps, its jerk has a median ratio of "
            f"{smoother[best][0]:.2f} and is less for {100 * smoother[best][1]:.0f} % of the "
            "plausible inputs. "
            + (
                "The decrease that the thesis expects is there."
                if smoother[best][1] > 0.75 and smoother[best][0] < 1.0
                else "The decrease that the thesis expects is not there in general: a fade delays "
                "a loop that picks one clutch at a time."
            ),
            f"The error {trend} with the length of the fade. Median ratios to steps: "
            + ", ".join(f"{v}: {r:.2f}" for v, r in worse.items())
            + ".",
            f"A fade of {both[-1]} has less jerk than steps for these shares of the plausible "
            f"inputs: {verdict(found, both[-1], STEP, 'jerk')}.",
        ),
        {"ratios": ratios(found, STEP)},
        ratio_picture(found, STEP, "Clutches faded in and out, against steps"),
        "Each dot is one set of plausible inputs; bars are medians.",
    )


def line_as_is(kind, gain, x):
    """The standard run."""
    return line(kind, gain, x)
