"""Backlash between a clutch and what turns it: nothing inside, a spring at either end."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


def wound_beyond(turn, gap):
    """How far a play of width ``gap`` is wound beyond its ends; signed, 0 inside."""
    return max(turn - 0.5 * gap, 0.0) + min(turn + 0.5 * gap, 0.0)


def left_behind(margin, way, size):
    """A margin, taken for used up by rounding of ``size`` only while ``way`` does not enlarge it.

    Where breakaway is the slip torque the plate begins to slide, and sticks, where it would go back
    at once.
    """
    return -margin if way > 0.0 and -1e-12 * size < margin < 0.0 else margin


@dataclass(frozen=True)
class ClutchBacklash(Effect):
    """A clutch whose plate is turned through a play with elastic ends, and has no inertia.

    Inside the play the clutch gives nothing; at its ends the plate is turned by ``stiffness`` times
    the winding beyond them until that reaches breakaway, and slides at the slip torque until the
    winding falls below that.  While it slides, winding beyond the slip torque goes within
    ``relaxation`` and gives no torque.  ``damping`` is the contact's; a contact never pulls.

    Source: M. Nordin, P.-O. Gutman, Automatica 38 (2002) 1633 (an elastic shaft with play), with a
    clutch as its load.

    Parameters
    ----------
    gap : float
        Whole width of the play [rad or m]; a run begins in its middle.
    stiffness : float
        Beyond its ends [N m/rad or N/m].
    damping : float
        Of a contact: a time constant on its winding [s].
    relaxation : float
        Time within which the winding beyond the slip torque is lost [s].
    """

    gap: float = parameter("coordinate", 0.0, low=0.0, typical=2e-3)
    stiffness: float = parameter("coordinate stiffness", 1e4, above=0.0, typical=1e4)
    damping: float = parameter("time", 0.0, low=0.0, typical=1e-4)
    relaxation: float = parameter("time", 3e-4, low=1e-5)

    states: ClassVar[tuple[str, ...]] = ("turn",)
    guards: ClassVar[tuple[str, ...]] = ("slide",)
    modes: ClassVar[int] = 1
    sizes: ClassVar[tuple[str, ...]] = ()
    family: ClassVar[str] = "backlash"
    acts_on: ClassVar[str] = "friction"
    reveals: ClassVar[str] = "Slow reversals at constant excitation, and light pushes to and fro."
    uses: ClassVar[tuple] = (wound_beyond, left_behind)

    @staticmethod
    def bristle_torque(level, slip, turn, dmode, modes_at, gap, stiffness, damping):
        wound = wound_beyond(turn, gap)
        if wound == 0.0:
            return 0.0
        side = 1.0 if wound > 0.0 else -1.0
        if dmode[modes_at] == 1:
            return side * min(level, stiffness * side * wound)
        return side * max(0.0, stiffness * (side * wound + damping * side * slip))

    @staticmethod
    def bristle_side(turn):
        return turn

    @staticmethod
    def turn_rate(level, slip, turn, engaged, dmode, modes_at, gap, stiffness, relaxation):
        wound = wound_beyond(turn, gap)
        if engaged == 0.0:  # the plate turns along; what was wound is let go
            return -wound / 0.01
        if dmode[modes_at] == 0:
            return slip
        most = level / stiffness
        return slip - (wound - min(max(wound, -most), most)) / relaxation

    @staticmethod
    def slide_guard(level, breakaway, slip, turn, dmode, modes_at, gap, stiffness):
        wound = stiffness * abs(wound_beyond(turn, gap))
        way = slip if turn > 0.0 else -slip
        size = level + stiffness * abs(turn)
        margin = breakaway - wound if dmode[modes_at] == 0 else wound - level
        if breakaway - level > 1e-12 * size:
            return margin
        return left_behind(margin, -way if dmode[modes_at] == 0 else way, size)

    @staticmethod
    def slide_jump(dmode, modes_at):
        dmode[modes_at] = 1 - dmode[modes_at]
