"""A supply that does what it is told after a dead time."""

from __future__ import annotations

from collections.abc import Sequence

from ...controllers.command_delay import CommandDelay
from ...controllers.drive_delay import KEPT
from ...effects.second_lag import SecondLag
from ...scenario import Scenario
from ..fitting.predictor import Parameter
from .effect_candidate import EffectCandidate

#: Longest delay that is looked for [s].
LONGEST = 0.05


def late_commands(
    declared: Scenario, clutches: Sequence[int], where: Sequence[str], test: str
) -> EffectCandidate:
    """Candidate: commands of these clutches act after one delay.

    As of a driver, a short one and a lag are two forms of one thing: own lags of 5 ms left a delay
    0.6 to 0.9 % more than the lag, a tester's delay of 8 ms a lag 3 % more.

    Parameters
    ----------
    declared : Scenario
        Its rate bounds the delay.
    clutches : sequence of int
        From 0.
    where : sequence of str
        Coordinates on which a residual may depend by it.
    test : str
        The experiment that shows it.
    """
    longest = min(LONGEST, (KEPT - 1) * declared.period)
    late = Parameter("command-delay.delay", 0.0, 0.0, longest, 0.002, unit="s")
    return EffectCandidate(
        "command-delay", (late,), ((min(0.005, 0.5 * longest),),), SecondLag.family,
        SecondLag.acts_on, tuple(where), test, sizes=(late.name,),
        stages=tuple(CommandDelay(clutch=i) for i in clutches),
    )  # fmt: skip
