"""A supply that follows the command no faster than so much, before the coil's lag."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


def least_time(way, slowness, slowness_down):
    """Time for a volt that way [s/V]; what is less than a microsecond is none."""
    time = slowness if way > 0 else slowness_down
    return time if time > 1e-6 else 0.0


def arrived(command):
    """Distance from a command at which an output is there, but for rounding [V]."""
    return 1e-9 * (1.0 + abs(command))


def short_of(command, output, way):
    """Positive while the output goes on as it does: on its way, or where it has arrived."""
    if way == 0:
        return arrived(command) - abs(command - output)
    return way * (command - output)


def set_out(y, dmode, command, output, way, slowness, slowness_down):
    """Stop where the command is, or set out for it; at once where nothing limits that way."""
    ahead = command - y[output]
    now = 0
    if abs(ahead) > arrived(command):
        now = 1 if ahead > 0.0 else -1
    if now == 0 or least_time(now, slowness, slowness_down) <= 0.0:
        y[output] = command
        now = 0
    dmode[way] = now


@dataclass(frozen=True)
class CommandSlew(Effect):
    """The clutch's lag follows an output that changes by ``1/slowness`` upwards and by
    ``1/slowness_down`` downwards at most, until it is the command.

    `SlewLimit` limits the excitation itself.

    Parameters
    ----------
    slowness, slowness_down : float
        Least time for a volt [s/V]; 0, and less than 1e-6: no limit.
    """

    slowness: float = parameter("time/voltage", 0.0, low=0.0, typical=0.005)
    slowness_down: float = parameter("time/voltage", 0.0, low=0.0, typical=0.005)

    states: ClassVar[tuple[str, ...]] = ("output",)
    settled: ClassVar[tuple[str, ...]] = ("output",)
    guards: ClassVar[tuple[str, ...]] = ("output",)
    modes: ClassVar[int] = 1
    sizes: ClassVar[tuple[str, ...]] = ("slowness", "slowness_down")
    family: ClassVar[str] = "supply"
    acts_on: ClassVar[str] = "actuator"
    reveals: ClassVar[str] = "Steps of several heights from zero and from a held level."
    uses: ClassVar[tuple] = (least_time, arrived, short_of, set_out)

    @staticmethod
    def seen_command(command, told_command, output, slowness, slowness_down):
        if slowness <= 1e-6 and slowness_down <= 1e-6:
            return command
        return max(0.0, command + output - told_command)

    @staticmethod
    def output_rate(dmode, modes_at, slowness, slowness_down):
        way = dmode[modes_at]
        return way / least_time(way, slowness, slowness_down) if way != 0 else 0.0

    @staticmethod
    def output_guard(command, output, dmode, modes_at):
        return short_of(command, output, dmode[modes_at])

    @staticmethod
    def output_jump(y, dmode, command, states_at, modes_at, slowness, slowness_down):
        set_out(y, dmode, command, states_at, modes_at, slowness, slowness_down)
