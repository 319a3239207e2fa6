"""6.2.1: another actuator in the same device: a magnetorheological brake, say."""

from __future__ import annotations

from ..clutch import Clutch
from ..laws import TestbedTorque
from ..rigs.inputs import Inputs
from ..rigs.line import line
from ..scenario import Scenario
from .delrin import law
from .study import Study
from .variants import ABOUT, comparison, ratio_picture, ratios, side_by_side, verdict

CLUTCH = "friction clutch"
#: Torque of (39) at rest and full command, which every brake here has, plus its drag [N m].
FULL = TestbedTorque.slip_torque(
    0.0, 10.0, 1.0, 0.0, TestbedTorque().offset, TestbedTorque().a, TestbedTorque().b,
    TestbedTorque().c,
)  # fmt: skip
#: Name -> time constant [s] (None: the clutch's), whether a gap closes, static gap, off-state drag.
BRAKES: dict[str, tuple[float | None, bool, float, float]] = {
    CLUTCH: (None, True, 1.0, 0.0),
    "no static gap": (None, True, 0.0, 0.0),
    "and 10 ms, no delay": (0.01, False, 0.0, 0.0),
    "with a quarter of the gain": (0.01, False, 0.0, 0.0),
    "and 0.5 % drag": (0.01, False, 0.0, 0.005),
    "and 1 % drag": (0.01, False, 0.0, 0.01),
    "and 2 % drag": (0.01, False, 0.0, 0.02),
}
#: From here on the torque feedback has a quarter of its gain, as the faster loop needs.
QUARTERED = tuple(BRAKES)[3:]


def braked(kind: str, gain: float, x: Inputs, which: str) -> Scenario:
    """The line with another brake in place of the four clutches.

    Off-state drag is the brake's own: its surface is always engaged and its map begins there.
    """
    lag, closes, gap, drag = BRAKES[which]
    t = law(gap)
    if drag > 0.0:
        t = TestbedTorque(c=drag * FULL / t.offset, d=t.d, e=t.e, f=drag * FULL)
    scenario = line(kind, 0.25 * gain if which in QUARTERED else gain, x, law=t)
    old = scenario.clutches[0]
    brake = Clutch(
        t,
        time_constant=old.time_constant if lag is None else lag,
        delay=old.delay if closes else 0.0,
        threshold=-1.0 if drag > 0.0 else old.threshold,
    )
    zero = (0.0,) * 4
    return scenario.replace(clutches=(brake,) * 4, command=zero, excitation=zero)


def words(which: str) -> str:
    """A brake's name outside its list."""
    return which.removeprefix("and ")


def other_brakes(size: int = 24) -> Study:
    """From the friction clutch to the magnetorheological brake, property by property."""
    variants = {name: lambda kind, gain, x, its=name: braked(kind, gain, x, its) for name in BRAKES}
    found = side_by_side(variants, size)
    fluid, fast, tuned = "and 1 % drag", "and 10 ms, no delay", "with a quarter of the gain"
    work = {v: found["baseline", v].work[0] for v in BRAKES}
    time = {v: found["baseline", v].time[0] for v in BRAKES}
    arrived = {v: int(found["baseline", v].reached[1:].sum()) for v in BRAKES}
    return Study(
        "Other brakes: no static gap, a fast fluid, and drag that never goes away",
        "thesis 6.2.1 (the actuator model exchanged); magnetorheological brakes: M. Jolly, J. "
        "Bender, J. Carlson, J. Intell. Mater. Syst. Struct. 10 (1999) 5 (milliseconds, no "
        "stiction, off-state drag)",
        ABOUT.format(size=size) + " All brakes have the slip torque of (39) at full command, those "
        "with drag about as much more; the properties of the fluid brake are added one after the "
        "other, its drag as a share of that torque. Kept as it is, the torque feedback's gain is "
        "beyond what the faster loop bears; hence a quarter of it in the rows that follow.",
        (comparison(found, CLUTCH, "On the line"),),
        (
            f"Fast and without a static gap the error is less for "
            f"{verdict(found, fast, CLUTCH, 'error')}, the jerk for "
            f"{verdict(found, fast, CLUTCH, 'jerk')}.",
            f"With a quarter of the feedback gain: error less for "
            f"{verdict(found, tuned, CLUTCH, 'error')}, jerk for "
            f"{verdict(found, tuned, CLUTCH, 'jerk')}.",
            f"With 1 % drag: error less for {verdict(found, fluid, CLUTCH, 'error')}, jerk for "
            f"{verdict(found, fluid, CLUTCH, 'jerk')}.",
            "The price of drag for the hand (baseline, nominal): "
            + "; ".join(f"{words(v)}: {time[v]:.2f} s, {work[v]:.1f} J" for v in QUARTERED)
            + f". Inputs of {size} with which the tip arrives within 6 s: "
            + ", ".join(f"{words(v)} {k}" for v, k in arrived.items())
            + ".",
        ),
        {"ratios": ratios(found, CLUTCH), "time": time, "work": work, "arrived": arrived},
        ratio_picture(found, CLUTCH, "Brakes, against friction clutches"),
        "Each dot is one set of plausible inputs; bars are medians.",
    )
