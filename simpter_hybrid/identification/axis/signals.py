"""Names of what a recording of one axis has."""

from __future__ import annotations

from dataclasses import dataclass

from ..recordings.map_units import PLAIN
from ..recordings.recording import Recording


@dataclass(frozen=True)
class AxisSignals:
    """Signals of a recording of one axis; a ``duty`` is of a ``supply``, where there is one.

    A drive of ``told`` is what a driver was told, not what a sensor saw: it has no noise.  Without
    any the ``reference`` drives: of the model's own position servo or of the end of its spring.
    `anew`: what follows it is set anew in windows.
    """

    position: str = "position"
    speed: str = "speed"
    drive: tuple[str, ...] = ("drive", "duty", "torque", "force", "current")
    told: tuple[str, ...] = ("drive", "duty", "supply", "reference")
    reference: str = "reference"
    supply: str = "supply"
    engaged: str = "torque_on"
    press: str = "pressure"
    anew: bool = False

    @property
    def all(self) -> tuple[str, ...]:
        """Names of all that is used."""
        rest = self.supply, self.engaged, self.press, self.reference
        return (self.position, self.speed, *self.drive, *rest)

    @property
    def sensed(self) -> frozenset[str]:
        """Names of drives that a sensor saw."""
        return frozenset(self.drive) - frozenset(self.told)

    def driving(self, recording: Recording) -> str | None:
        """Name of what drives the axis: the first `drive`, or the reference; None if let alone."""
        every = (*self.drive, self.reference)
        return next((name for name in every if name in recording.channels), None)

    def supplied(self, recording: Recording) -> bool:
        """Whether what drives it is a part of the supply: a duty, or plain numbers."""
        name = self.driving(recording)
        plain = name == "duty" or (name is not None and recording.channels[name].unit in PLAIN)
        return plain and self.supply in recording.channels
