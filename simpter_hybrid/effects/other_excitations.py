"""Clutches on one supply: what flows through the others' coils changes what this one gets."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from .other_commands import OtherCommands


@dataclass(frozen=True)
class OtherExcitations(OtherCommands):
    """The command seen grows by ``gain`` times the sum of all other clutches' excitations, and by
    ``relative`` times that sum times itself; never below 0.

    Excitations follow commands through their coils: a supply sags by the currents it carries.
    A command of 0 stays 0.

    Parameters
    ----------
    gain : float
        Volts a volt; negative: a wire in common.
    relative : float
        Part of the own command for each volt of the others; negative: the supply sags [1/V].
    """

    family: ClassVar[str] = "cross-coupling"
    acts_on: ClassVar[str] = "actuator"
    reveals: ClassVar[str] = "Steps of one clutch shortly after those of another."

    @staticmethod
    def seen_command(command, y, n, m, excitation, gain, relative):
        total = -excitation
        for i in range(m):
            total += y[2 * n + i]
        changed = command + (gain + relative * command) * total
        return max(0.0, changed) if command > 0.0 else command
