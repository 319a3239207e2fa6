"""A force that repeats along an axis so finely that no simulated window can follow it.

Within a window it passes many times, and a little too much speed puts it out of step.  What it does
to the recorded accelerations goes by the recorded place, and other runs show it again.
"""

from __future__ import annotations

from .axis.position_waves import Repeats, seen_again
from .axis.traces import AxisTracer
from .fitting.fitted_model import Split
from .tracing.traced import Tracer

#: Least part of a mean square that a wave takes away on runs that select, as large as those that
#: fit show it.
LEAST = 0.1
#: ... and fewest waves in the whole way: a drive that lags by 20 to 50 ms made some of 2.7 to 6.3.
OFTEN = 10.0
#: The coordinate on which such a lack depends.
WHERE = "force:position"


def repeating(tracer: Tracer, split: Split) -> Repeats | None:
    """A wave of a force that runs that fit and runs that select show alike; None if none is."""
    if not isinstance(tracer, AxisTracer) or tracer.drawn or tracer.turn == 0.0:
        return None
    found = seen_again(split.fit, split.select)
    told = found is not None and found.part >= LEAST and found.times >= OFTEN
    return found if told else None
