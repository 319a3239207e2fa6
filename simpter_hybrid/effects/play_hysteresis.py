"""Hysteresis between excitation and torque: plays (backlash elements) side by side."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


def played(excitation, memory, width):
    """Output of a play with the half width ``width`` [V] that remembers ``memory``."""
    return min(max(memory, excitation - width), excitation + width)


def play_edge(excitation, rate, memory, width, side):
    """Positive while the play stays as it is.

    ``side``: 1 or -1 dragged along by a rising or falling excitation, 2 or -2 within its width and
    heading for that edge, 0 not known yet.
    """
    if side == 0:
        return -1.0
    if rate == 0.0:  # an excitation without lag jumps: it may be beyond either edge
        # The millionth is for rounding of one that was dragged there.
        return width * (1.0 + 1e-6) - abs(excitation - memory)
    if side == 1 or side == -1:
        return side * rate
    way = 0.5 * side
    behind = width + way * (excitation - memory)
    if way * rate < 0.0 and abs(behind) <= 1e-9 * width:
        # It has just left that edge, and only by rounding is not yet on its way.
        return behind + 1e-9 * width
    return min(width - way * (excitation - memory), way * rate)


def play_step(y, dmode, excitation_at, state, mode, width):
    """Enter what follows: another heading, or being dragged."""
    u = y[excitation_at]
    side = dmode[mode]
    if side == 0:
        dmode[mode] = 2
    elif side == 1 or side == -1:
        dmode[mode] = -2 * side
    elif width - 0.5 * side * (u - y[state]) > 1e-9 * width:
        dmode[mode] = -side
    else:
        dmode[mode] = side // 2
    y[state] = played(u, y[state], width)


@dataclass(frozen=True)
class PlayHysteresis(Effect):
    """The torque map sees an excitation that lags behind turning points (remanence).

    ``share`` of the excitation passes through three plays with half widths ``width`` times 1/3, 2/3
    and 1 (Prandtl-Ishlinskii): after a turning point the effective excitation stays behind by up to
    that much.  A clutch that goes off forgets nothing, but has no torque.

    Source: M. Brokate, J. Sprekels, Hysteresis and Phase Transitions (1996), section 2.3.

    Parameters
    ----------
    share : float
        Share of the excitation that has a memory.
    width : float
        Half width of the widest play [V].
    lift : float
        Where the declared map lies: 0 at an excitation without memory, 1 on the first rise from
        zero (a map measured upwards), between them inside the loop.
    """

    share: float = parameter("dimensionless", 0.0, low=0.0, high=1.0, typical=0.3)
    width: float = parameter("voltage", 0.5, low=0.0, typical=0.2)
    lift: float = parameter("dimensionless", 0.0, low=0.0, high=2.0, typical=0.5)

    states: ClassVar[tuple[str, ...]] = ("first", "second", "third")
    guards: ClassVar[tuple[str, ...]] = ("first", "second", "third")
    modes: ClassVar[int] = 3
    sizes: ClassVar[tuple[str, ...]] = ("share",)
    family: ClassVar[str] = "hysteresis"
    acts_on: ClassVar[str] = "actuator"
    reveals: ClassVar[str] = "Staircase of command up and down with minor loops at constant speed."
    uses: ClassVar[tuple] = (played, play_edge, play_step)

    @staticmethod
    def effective_excitation(excitation, first, second, third, share, width, lift):
        behind = min(excitation, width / 3.0) + min(excitation, width / 1.5)
        behind = (behind + min(excitation, width)) / 3.0
        mean = played(excitation, first, width / 3.0) + played(excitation, second, width / 1.5)
        mean = (mean + played(excitation, third, width)) / 3.0
        return max(0.0, excitation + share * (mean - excitation + lift * behind))

    @staticmethod
    def first_rate(rate, dmode, modes_at):
        return rate if abs(dmode[modes_at]) == 1 else 0.0

    @staticmethod
    def second_rate(rate, dmode, modes_at):
        return rate if abs(dmode[modes_at + 1]) == 1 else 0.0

    @staticmethod
    def third_rate(rate, dmode, modes_at):
        return rate if abs(dmode[modes_at + 2]) == 1 else 0.0

    @staticmethod
    def first_guard(excitation, rate, first, width, dmode, modes_at):
        return play_edge(excitation, rate, first, width / 3.0, dmode[modes_at])

    @staticmethod
    def second_guard(excitation, rate, second, width, dmode, modes_at):
        return play_edge(excitation, rate, second, width / 1.5, dmode[modes_at + 1])

    @staticmethod
    def third_guard(excitation, rate, third, width, dmode, modes_at):
        return play_edge(excitation, rate, third, width, dmode[modes_at + 2])

    @staticmethod
    def first_jump(y, dmode, excitation_at, states_at, modes_at, width):
        play_step(y, dmode, excitation_at, states_at, modes_at, width / 3.0)

    @staticmethod
    def second_jump(y, dmode, excitation_at, states_at, modes_at, width):
        play_step(y, dmode, excitation_at, states_at + 1, modes_at + 1, width / 1.5)

    @staticmethod
    def third_jump(y, dmode, excitation_at, states_at, modes_at, width):
        play_step(y, dmode, excitation_at, states_at + 2, modes_at + 2, width)
