"""Play in a gear or a joint: nothing inside it, an elastic contact at either end."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


def contact_side(position, phase):
    """Side of the contact, 1.0 or -1.0: kept while it lasts; apart that of the nearer end."""
    if phase == 0:
        return 1.0 if position > 0.0 else -1.0
    return 1.0 if phase > 0 else -1.0


def not_passed(left, away):
    """Positive while a place is ahead, or ``away`` says that it is left behind.

    A place may have been left at this instant; one passed by more than rounding, where a run
    starts or is restarted beyond it, counts whichever way one goes.
    """
    return left if left < -1e-9 else max(left, away)


def inner_margin(depth, approach, peak, restitution, phase):
    """Positive until an unloading contact loads again, or a released one touches."""
    ahead = peak if phase == 2 else peak * (1.0 - restitution * restitution)
    return not_passed(ahead - depth, -approach)


def outer_margin(depth, approach, peak, restitution, phase):
    """Positive until an unloading contact is released, or a released one is apart."""
    behind = peak * (1.0 - restitution * restitution) if phase == 2 else 0.0
    return not_passed(depth - behind, approach)


def contact_margin(depth, approach, peak, restitution, phase):
    """Positive while the contact stays in its phase: apart, loading, unloading, released."""
    if phase == 0:
        return not_passed(-depth, -approach)
    if phase == 1:
        return depth if depth < -1e-9 else approach
    return min(
        inner_margin(depth, approach, peak, restitution, phase),
        outer_margin(depth, approach, peak, restitution, phase),
    )


def next_phase(depth, approach, peak, restitution, phase):
    """The phase that follows: inwards or outwards, whichever margin is used up."""
    if phase == 0:
        return 1 if approach > 0.0 else 2
    if phase == 1:
        return 0 if depth < -1e-9 else 2
    inner = inner_margin(depth, approach, peak, restitution, phase)
    if inner < outer_margin(depth, approach, peak, restitution, phase):
        return phase - 1
    return 3 if phase == 2 else 0


def contact_step(depth, approach, y, peak_at, dmode, at, restitution, side):
    """Enter the phase that follows; unloading begins at the deepest, apart nothing is kept."""
    phase = abs(dmode[at])
    now = next_phase(depth, approach, y[peak_at], restitution, phase)
    if now == 0:
        y[peak_at] = 0.0
    elif now == 2 and phase < 2:
        y[peak_at] = depth
    dmode[at] = now if side > 0.0 else -now


@dataclass(frozen=True)
class Backlash(Effect):
    """Contact forces at either end of a gap, on a coordinate that measures where in it one is.

    A contact loads along ``stiffness depth`` and unloads along a line ``1/restitution^2`` steeper,
    so that a free impact gives back the share ``restitution`` of its speed, whatever the speed:
    energy is kept (1) or lost as declared.  Put it on the coordinate of a shaft
    (``devices.extended.with_shaft``) for a gear.

    Source: O. Walton, R. Braun, J. Rheology 30 (1986) 949 (the latching spring).

    Parameters
    ----------
    gap : float
        Whole width [rad or m]; the coordinate is 0 in its middle.
    stiffness : float
        Of the contacts while loading [N m/rad or N/m]; 0: no contact at all.
    restitution : float
        Speed after over speed before a free impact.
    """

    gap: float = parameter("coordinate", 0.0, low=0.0, typical=2e-3)
    stiffness: float = parameter("coordinate stiffness", 0.0, low=0.0, typical=1e3)
    restitution: float = parameter("dimensionless", 1.0, above=0.0, high=1.0)

    states: ClassVar[tuple[str, ...]] = ("peak",)
    guards: ClassVar[tuple[str, ...]] = ("contact",)
    modes: ClassVar[int] = 1
    sizes: ClassVar[tuple[str, ...]] = ("stiffness",)
    family: ClassVar[str] = "play"
    acts_on: ClassVar[str] = "load"
    reveals: ClassVar[str] = "Slow reversals, and free motion tapped to and fro with clutches off."
    uses: ClassVar[tuple] = (
        contact_side, not_passed, inner_margin, outer_margin, contact_margin, next_phase,
        contact_step,
    )  # fmt: skip

    @staticmethod
    def force(position, peak, dmode, modes_at, gap, stiffness, restitution):
        side = contact_side(position, dmode[modes_at])
        depth = side * position - 0.5 * gap
        phase = abs(dmode[modes_at])
        if phase == 1:
            return -side * stiffness * depth
        if phase == 2:
            square = restitution * restitution
            return -side * stiffness / square * (depth - peak * (1.0 - square))
        return 0.0

    @staticmethod
    def peak_rate():
        return 0.0

    @staticmethod
    def contact_guard(position, speed, peak, dmode, modes_at, gap, restitution):
        side = contact_side(position, dmode[modes_at])
        depth = side * position - 0.5 * gap
        phase = abs(dmode[modes_at])
        return contact_margin(depth, side * speed, peak, restitution, phase)

    @staticmethod
    def contact_jump(position, speed, y, dmode, states_at, modes_at, gap, restitution):
        side = contact_side(position, dmode[modes_at])
        depth = side * position - 0.5 * gap
        contact_step(depth, side * speed, y, states_at, dmode, modes_at, restitution, side)
