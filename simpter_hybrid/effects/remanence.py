"""Remanence: one play between excitation and torque."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter
from .play_hysteresis import play_edge, play_step, played


@dataclass(frozen=True)
class Remanence(Effect):
    """The torque map sees the excitation through a play of half width ``width``.

    After every turning point the torque stays what it was until the excitation has come back by
    twice the half width.  Source: as ``PlayHysteresis``.

    Parameters
    ----------
    width : float
        Half width [V].
    """

    width: float = parameter("voltage", 0.0, low=0.0, typical=0.2)

    states: ClassVar[tuple[str, ...]] = ("memory",)
    guards: ClassVar[tuple[str, ...]] = ("side",)
    modes: ClassVar[int] = 1
    sizes: ClassVar[tuple[str, ...]] = ("width",)
    family: ClassVar[str] = "hysteresis"
    acts_on: ClassVar[str] = "actuator"
    reveals: ClassVar[str] = "Staircase of command up and down at constant speed."
    uses: ClassVar[tuple] = (played, play_edge, play_step)

    @staticmethod
    def effective_excitation(excitation, memory, width):
        return max(0.0, played(excitation, memory, width))

    @staticmethod
    def memory_rate(rate, dmode, modes_at):
        return rate if abs(dmode[modes_at]) == 1 else 0.0

    @staticmethod
    def side_guard(excitation, rate, memory, width, dmode, modes_at):
        return play_edge(excitation, rate, memory, width, dmode[modes_at])

    @staticmethod
    def side_jump(y, dmode, excitation_at, states_at, modes_at, width):
        play_step(y, dmode, excitation_at, states_at, modes_at, width)
