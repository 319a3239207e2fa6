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
        "thesis, section 6.3.2; the friction curves of this pair are not printed, so the gap "
        "between static and sliding friction is varied instead",
        ABOUT.format(size=size)
        + " The variants multiply the gap between the breakaway torque, equation (43), and the "
        "slip torque at rest, equation (39). Besides, one clutch at 4 V is dragged at constant "
        "speed by a cable with a stiffness of 75 N m/rad and a damping of 0.5 N m s/rad.",
        (
            comparison(found, STEEL, "On the line"),
            drag_table(dragged),
        ),
        (
            "On the line, no gap at all means less jerk for these shares of the plausible inputs: "
            f"{verdict(found, even, STEEL, 'jerk')}. That is more than three quarters with: "
            f"{', '.join(better) or 'no controller'}.",
            "No gap at all means less error for these shares: "
            f"{verdict(found, even, STEEL, 'error')}.",
            f"When one clutch is dragged at {SPEEDS[0]:g} rad/s with the gap of steel, the cable's "
            f"torque swings by {steel[0]:.1f} lb-in and the clutch sticks again "
            f"{times(steel[1])}; without a gap the torque swings by {none[0]:.1f} lb-in and the "
            f"clutch sticks again {times(none[1])}. Here, where one clutch sticks and slips "
            "against a spring, the gap is the cause.",
        ),
        {"ratios": ratios(found, STEEL), "dragged": {str(k): v for k, v in dragged.items()}},
        ratio_picture(found, STEEL, "Gap between static and sliding friction"),
        "Each dot is one set of plausible inputs; bars are medians.",
    )


def times(count: int) -> str:
    """A count in words."""
    return "1 time" if count == 1 else f"{count} times"


def drag_table(dragged: dict[float, dict[float, tuple[float, int]]]) -> Table:
    """Swing and sticking by gap and speed."""
    return Table(
        "One clutch at 4 V, dragged by a cable for 6 s: by how much the cable's torque swings "
        "after the clutch first slips [lb-in], and in brackets how often the clutch sticks again",
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
