"""Signals of a recording that make up a rotor rig."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class RotorSignals:
    """Names as in its map."""

    transmitted: str = "clutch_torque"
    applied: str = "motor_torque"
    speed: str = "speed"
    position: str = "position"
    command: str = "command"
    prescribed: str = "reference_torque"
    inputs: tuple[str, ...] = (
        "reference_speed",
        "reference_torque",
        "command",
        "neighbour_command",
        "servo_mode",
    )

    @property
    def all(self) -> tuple[str, ...]:
        """Names of all that is used."""
        own = self.transmitted, self.applied, self.speed, self.position
        return (*own, self.command, self.prescribed, *self.inputs)
