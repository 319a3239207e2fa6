"""Names of what a recording of one axis has."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from ..recordings.channel_map import ChannelMap
from ..recordings.map_units import PLAIN
from ..recordings.recording import Recording

#: Beginning of the name of what was measured beside another drive.
SEEN = "seen_"


@dataclass(frozen=True)
class AxisSignals:
    """Signals of a recording of one axis; a ``duty`` is of a ``supply``, where there is one.

    A drive of ``told`` is what a driver was told, not what a sensor saw: it has no noise.  Without
    any the ``reference`` drives: of the model's own position servo or of the end of its spring.
    `seen` is what a sensor saw of what another channel drives: a current beside the voltage.
    `anew`: what follows it is set anew in windows.
    """

    position: str = "position"
    speed: str = "speed"
    drive: tuple[str, ...] = ("drive", "duty", "torque", "force", "current")
    told: tuple[str, ...] = ("drive", "duty", "supply", "reference")
    reference: str = "reference"
    seen: tuple[str, ...] = ("seen_torque", "seen_force", "seen_current")
    supply: str = "supply"
    engaged: str = "torque_on"
    press: str = "pressure"
    anew: bool = False

    @property
    def all(self) -> tuple[str, ...]:
        """Names of all that is used."""
        rest = self.supply, self.engaged, self.press, self.reference
        return (self.position, self.speed, *self.drive, *self.seen, *rest)

    def beside(self, channels: Mapping[str, ChannelMap]) -> dict[str, str]:
        """Drives that were measured beside another that is the input -> their names in `seen`.

        None of an axis that is moved, whose force is compared.
        """
        if any(n in channels and channels[n].role == "input" for n in (self.position, self.speed)):
            return {}
        there = [name for name in self.drive if name in channels]
        driven = any(channels[name].role == "input" for name in there)
        names = {kept.removeprefix(SEEN): kept for kept in self.seen}
        measured = (n for n in there if n in names and channels[n].role == "measured")
        return {name: names[name] for name in measured} if driven else {}

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
