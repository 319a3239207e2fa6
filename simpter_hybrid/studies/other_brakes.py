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
        "thesis, section 6.2.1 (another model of the actuator); on magnetorheological brakes: M. "
        "Jolly, J. Bender, J. Carlson, J. Intell. Mater. Syst. Struct. 10 (1999) 5 (response "
        "within milliseconds, no stiction, drag when switched off)",
        ABOUT.format(size=size) + " At full command every brake has the slip torque of equation "
        "(39); a brake with drag exceeds it by about its drag. The properties of the fluid brake "
        "are added one after the other, its drag as a share of that torque. With the gain left as "
        "it is, the torque feedback is too strong for the faster loop; the rows that follow "
        "therefore have a quarter of that gain.",
        (comparison(found, CLUTCH, "On the line"),),
        (
            "A fast brake without a static gap means less error than the friction clutch for these "
            f"shares of the plausible inputs: {verdict(found, fast, CLUTCH, 'error')}. It means "
            f"less jerk for these: {verdict(found, fast, CLUTCH, 'jerk')}.",
            "With a quarter of the feedback gain as well, there is less error for these shares: "
            f"{verdict(found, tuned, CLUTCH, 'error')}. There is less jerk for these: "
            f"{verdict(found, tuned, CLUTCH, 'jerk')}.",
            "With 1 % drag added, there is less error for these shares: "
            f"{verdict(found, fluid, CLUTCH, 'error')}. There is less jerk for these: "
            f"{verdict(found, fluid, CLUTCH, 'jerk')}.",
            "What drag costs the hand in time and work (baseline, nominal inputs): "
            + "; ".join(f"{words(v)}: {time[v]:.2f} s, {work[v]:.1f} J" for v in QUARTERED)
            + f". Of {size} sets of plausible inputs, the tip reaches the end within 6 s with this "
            "many: " + "; ".join(f"{words(v)}: {k}" for v, k in arrived.items()) + ".",
        ),
        {"ratios": ratios(found, CLUTCH), "time": time, "work": work, "arrived": arrived},
        ratio_picture(found, CLUTCH, "Brakes, against friction clutches"),
        "Each dot is one set of plausible inputs; bars are medians.",
    )
