"""6.3.2: a pair of materials whose static friction is nearer to its sliding friction."""

from __future__ import annotations

import numpy as np

from ..compiled import simulate
from ..laws import LBF_IN, TestbedTorque
from ..loads.moving_hand import MovingHand
from ..measuring.sampling import sample
from ..reproduce.standard import CONTROLLERS
from ..rigs.line import line
from ..rigs.torque_bar import torque_bar
from .study import Study, Table
from .variants import ABOUT, comparison, pairs, ratio_picture, ratios, side_by_side, verdict

#: Share of the gap between (39) at rest and (43) that is left.
SHARES = (1.5, 1.0, 0.5, 0.0)
STEEL = "steel (gap x 1)"
#: Speeds at which a clutch at 4 V is dragged [rad/s], and the cable [N m/rad, N m s/rad].
SPEEDS = (0.05, 0.1, 0.2, 0.4)
CABLE = (75.0, 0.5)


def law(share: float) -> TestbedTorque:
    """The testbed's maps with a share of the gap between static and sliding friction."""
    t = TestbedTorque()
    rest = [t.offset * v for v in (t.a, t.b, t.c)]
    wide = [r + share * (b - r) for r, b in zip(rest, (t.d, t.e, t.f), strict=True)]
    return TestbedTorque(d=wide[0], e=wide[1], f=wide[2])


def name_of(share: float) -> str:
    """Words for a share."""
    return STEEL if share == 1.0 else f"gap x {share:g}"


def delrin(size: int = 24) -> Study:
    """The line with smaller and larger gaps, and one clutch dragged slowly by a cable."""
    variants = {
        name_of(share): lambda kind, gain, x, its=share: line(kind, gain, x, law=law(its))
        for share in SHARES
    }
    found = side_by_side(variants, size)
    dragged = {share: {v: drag(share, v) for v in SPEEDS} for share in SHARES}
    even = name_of(0.0)
    better = [c for c in CONTROLLERS if pairs(found[c, even], found[c, STEEL], "jerk")[1] > 0.75]
    steel, none = dragged[1.0][SPEEDS[0]], dragged[0.0][SPEEDS[0]]
    return Study(
        "Delrin on steel: does a smaller gap between static and sliding make it smoother?",
        "thesis 6.3.2; what the pair's curves are is not printed, the gap is varied instead",
        ABOUT.format(size=size)
        + " The gap between breakaway (43) and slip torque at rest (39) is multiplied. One clutch "
        "at 4 V is also dragged at constant speed through a cable of 75 N m/rad and 0.5 N m s/rad.",
        (
            comparison(found, STEEL, "On the line"),
            drag_table(dragged),
        ),
        (
            "On the line jerk falls with no gap at all for these shares of the plausible inputs: "
            f"{verdict(found, even, STEEL, 'jerk')}; for more than three quarters with "
            f"{', '.join(better) or 'no controller'}.",
            f"Tracking: the error is smaller for {verdict(found, even, STEEL, 'error')}.",
            f"A clutch dragged at {SPEEDS[0]:g} rad/s swings by {steel[0]:.1f} lb-in and sticks "
            f"{steel[1]} times with steel, by {none[0]:.1f} lb-in and {none[1]} times without a "
            "gap: there, where one clutch sticks and slips against a spring, the gap is the cause.",
        ),
        {"ratios": ratios(found, STEEL), "dragged": {str(k): v for k, v in dragged.items()}},
        ratio_picture(found, STEEL, "Gap between static and sliding friction"),
        "Each dot is one set of plausible inputs; bars are medians.",
    )


def drag_table(dragged: dict[float, dict[float, tuple[float, int]]]) -> Table:
    """Swing and sticking by gap and speed."""
    return Table(
        "One clutch at 4 V dragged by a cable for 6 s: swing of the cable's torque after the first "
        "slip [lb-in], and how often the clutch stuck again",
        ("gap", *(f"{v:g} rad/s" for v in SPEEDS)),
        tuple(
            (name_of(s), *(f"{a:.1f} ({k})" for a, k in row.values())) for s, row in dragged.items()
        ),
    )


def drag(share: float, speed: float) -> tuple[float, int]:
    """Swing of the cable's torque after the first slip [lb-in], and how often the clutch stuck."""
    hand = MovingHand(speed, *CABLE)
    run = simulate(torque_bar(4.0, law(share)).replace(loads=(hand,), t_end=6.0, stops=()))
    stuck = sum(e.kind == "slip stop" and e.after[0] == 0 for e in run.events)
    first = next(e.t for e in run.events if e.kind == "breakaway")
    seen = sample(run, np.linspace(first, run.t_end, 4000))
    return float(np.ptp(seen.load[:, 0])) / LBF_IN, stuck
