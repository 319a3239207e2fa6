"""Figures 37-40: the baseline run seen from the tip and from the clutches."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..known_units import INCH
from ..measuring.metrics import differences
from ..measuring.sampling import sample
from ..measuring.transitions import transitions
from .rows import Engine, Row, claim
from .standard import plausible, standard


def baseline(engine: Engine, draws: int = 64) -> list[Row]:
    """What 5.3.2 says about the run."""
    trajectory = standard(engine, "baseline")
    grid = np.arange(int(trajectory.t_end / 1e-3)) * 1e-3
    found = sample(trajectory, grid)
    last = sample(trajectory, [trajectory.t_end]).tip
    x, y = np.concatenate([found.tip, last]).T / INCH
    slip = found.slip
    counted = transitions(trajectory)
    lasting = [b - a for spans in counted.flat for a, b in spans]
    return [
        claim(
            "A31",
            "Figure 37: the path stays within y = 20 to 28 in and reaches x = -28 in",
            "20-28 in",
            f"y {y.min():.2f} to {y.max():.2f} in, x from {x[0]:.2f} to {x[-1]:.2f} in",
            bool(y.min() > 20.0 and y.max() < 28.0 and x[-1] < -28.0 + 1e-6),
        ),
        claim(
            "A36",
            "Figure 38: all slip velocities lie between -0.5 and 1 rad/s",
            "[-0.5, 1] rad/s",
            f"{slip.min():.2f} to {slip.max():.2f} rad/s",
            bool(slip.min() > -0.5 and slip.max() < 1.0),
            why="the axis limits bound what was plotted",
        ),
        *flat(engine, counted, draws),
        claim(
            "A36",
            "the flat portions last a finite time",
            "finite",
            "; ".join(
                f"clutch {i + 1}: " + ", ".join(f"{1e3 * (b - a):.1f} ms" for a, b in spans)
                for i, spans in enumerate(counted.flat)
                if spans
            ),
            min(lasting, default=0.0) >= trajectory.scenario.period,
            why="at least a sample period, 6.7 ms: a shorter rest shows at one sample or at none",
        ),
        *jerk_rows(trajectory, found, counted),
    ]


def flat(engine: Engine, counted, draws: int) -> list[Row]:
    """Which clutches rest, and how often."""
    every = [runs["baseline"] for runs in plausible(engine, draws) if runs["baseline"].finished]
    both = float(np.mean([r.flat_portions[1] > 0 and r.flat_portions[2] > 0 for r in every]))
    share = float(np.mean([two_and_four(r.flat_portions) for r in every]))
    six = [r.transitions for r in every]
    low, high = np.quantile(six, [0.05, 0.95])
    return [
        claim(
            "A36 S54",
            "slip velocities stay at zero for a while: clutch 2 twice and another four times",
            "six in all",
            f"clutches 1-4: {', '.join(str(c) for c in counted.counts)} flat portions; turned "
            "round "
            f"without rest: {', '.join(str(c) for c in counted.reversals)}. Over {len(every)} "
            f"plausible inputs {low:.0f} to {high:.0f} in all, and both clutches 2 and 3 rest in "
            f"{100 * both:.0f} %",
            two_and_four(counted.counts),
            why="the number hangs on the operator's sinusoids, which are not printed, and on the "
            "clutches' breakaway after a stop that the command has left",
            share=share,
            flat=counted.counts,
        ),
        claim(
            "A36",
            "the clutch with four flat portions is clutch 4 (5.3.2)",
            "clutch 4, where Figure 39 shows clutch 3",
            "the slip velocity of clutch 4 does not vanish on this path; that of clutch 3 does at "
            "x = 0 and that of clutch 2 near x = -20.7 in",
            counted.counts[3] > 0,
            why="a slip of the text: Figure 39 draws clutches 2 and 3",
        ),
    ]


def two_and_four(counts: Sequence[int]) -> bool:
    """Whether clutch 2 rests twice, one other clutch four times and the others never."""
    return counts[1] == 2 and sorted([*counts[:1], *counts[2:]]) == [0, 0, 4]


def jerk_rows(trajectory, found, counted) -> list[Row]:
    """Figures 39 and 40: peaks of jerk at transitions, and steep gradients of acceleration."""
    jerk = differences(found.t, found.tip_acceleration)
    size = np.linalg.norm(found.tip_acceleration, axis=1)
    steep = np.append(0.0, np.abs(np.diff(size)) / 1e-3)
    ends = np.array([t for spans in counted.flat for span in spans for t in span])
    peaks = np.sort(found.t[np.argsort(jerk)[-6:]])
    near = [float(np.abs(ends - t).min()) for t in peaks] if len(ends) else [np.inf]
    at_ends = sum(d < 2.5e-3 for d in near)
    both = float(np.mean(np.isin(np.argsort(jerk)[-30:], np.argsort(steep)[-60:])))
    every = np.array([e.t for e in trajectory.events])
    events = sum(float(np.abs(every - t).min()) < 2.5e-3 for t in peaks)
    return [
        claim(
            "A37",
            "Figure 39: jerk peaks whenever a clutch sticks or lets go",
            "peaks at transitions",
            f"of the six largest 1 ms differences {at_ends} lie at the ends of flat portions and "
            f"{events} at mode changes of any kind",
            at_ends >= 5,
            why="" if at_ends >= 5 else "stops that let go at once jump as well",
            at_ends=at_ends,
            at_events=events,
        ),
        claim(
            "A37",
            "Figure 40: places of high jerk are those of steep acceleration",
            "high gradients",
            f"{100 * both:.0f} % of the 30 largest jerks are among the 60 steepest accelerations",
            both > 0.8,
            why="a jump that turns the acceleration without changing its size would be missed",
        ),
    ]
