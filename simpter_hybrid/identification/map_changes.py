"""What a map may have wrong: each as the change of the recording that would put it right."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass, replace
from math import pi

from .channel_factors import EDGES, Factors, with_exchanged, with_factors
from .recordings.off_axis import OffAxis, put_even, put_on_axis
from .recordings.recorded_run import RecordedRun
from .recordings.recording import Recording

#: Factor that puts a channel right -> unit that it has, and not the one of the map.
INSTEAD = {
    180.0 / pi: "radians, not degrees", pi / 180.0: "degrees, not radians",
    2.0 * pi: "turns, not radians", 0.5 / pi: "radians, not turns",
    360.0: "turns, not degrees", 1.0 / 360.0: "degrees, not turns",
    30.0 / pi: "radians a second, not turns a minute",
    pi / 30.0: "turns a minute, not radians a second",
    6.0: "turns a minute, not degrees a second", 1.0 / 6.0: "degrees a second, not turns a minute",
    60.0: "turns a second, not turns a minute", 1.0 / 60.0: "turns a minute, not turns a second",
    3.6: "metres a second, not kilometres an hour",
    1.0 / 3.6: "kilometres an hour, not metres a second",
}  # fmt: skip
#: Channels of what moves, and of forces, by the beginnings of their names.
MOVING, FORCES = ("position", "speed"), ("force", "torque", "load")
#: What is wrong where it is no mistake of the map but one of the sensor.
OFF_AXIS, RIPPLE, OWN_ZERO = "encoder off its axis", "tachometer's ripple", "zero of each run"


def unit_instead(factor: float) -> str:
    """Which unit a channel has, and not that of its map, if this factor puts it right; or ""."""
    return next((said for f, said in INSTEAD.items() if abs(factor / f - 1.0) < 1e-6), "")


@dataclass(frozen=True)
class MapChange(ABC):
    """Channels that are read otherwise than the map says.

    Parameters
    ----------
    channels : tuple of str
    """

    channels: tuple[str, ...]

    @property
    @abstractmethod
    def kind(self) -> str:
        """What of the map would be wrong."""

    @property
    @abstractmethod
    def done(self) -> str:
        """What is done to the channels, in words."""

    @abstractmethod
    def made(self, recording: Recording) -> Recording:
        """The recording so changed."""

    @property
    def slight(self) -> bool:
        """Whether a wrong number in the model, or an effect, may do as much."""
        return False

    @property
    def unlike(self) -> bool:
        """Whether no number in the model and no effect does anything like it."""
        return False

    @property
    def right(self) -> str:
        """What to write instead, where it is refused."""
        return ""

    def factors(self, recording: Recording) -> Factors:
        """What channels are multiplied by, and so the deviations in which they are judged."""
        return {}


@dataclass(frozen=True)
class Times(MapChange):
    """Channels times a factor: another sign, unit or gain."""

    factor: float

    @property
    def kind(self) -> str:
        if self.factor < 0.0:
            return "sign"
        return "gain (`times`)" if self.slight else "unit"

    @property
    def done(self) -> str:
        if self.factor < 0.0:
            return "turned round"
        said = unit_instead(self.factor)
        return f"times {self.factor:.4g}" + (f" ({said})" if said else "")

    @property
    def slight(self) -> bool:
        return 1.0 / max(EDGES) <= self.factor <= max(EDGES)

    @property
    def unlike(self) -> bool:
        return self.factor < 0.0

    @property
    def right(self) -> str:
        if self.factor < 0.0:
            return "one direction for what drives and what moves: the other sign here"
        said, other = "the unit that the logger had", f"{1.0 / self.factor:.4g} times"
        if all(n.startswith(MOVING) for n in self.channels):
            return (
                f"{said}; where forces move it, forces that are {other} those declared, or an "
                f"inertia that is {self.factor:.4g} times the declared one, would do about as much"
            )
        if all(n.startswith(FORCES) for n in self.channels):
            return (
                f"{said}; an inertia, with its friction, that is {other} the declared one would "
                "do about as much"
            )
        return f"{said}; or is a number of the model that belongs to it off by as much?"

    def factors(self, recording: Recording) -> Factors:
        """Of the channels, and of positions that are one of them summed up."""
        summed = (
            n for n, c in recording.channels.items()
            if c.summed and n.replace("position", "speed", 1) in self.channels
        )  # fmt: skip
        return dict.fromkeys((*self.channels, *summed), self.factor)

    def made(self, recording: Recording) -> Recording:
        return with_factors(recording, self.factors(recording))


@dataclass(frozen=True)
class Exchanged(MapChange):
    """Each two channels in a row in one another's place."""

    @property
    def kind(self) -> str:
        return "column"

    @property
    def done(self) -> str:
        return "exchanged"

    @property
    def unlike(self) -> bool:
        return True

    @property
    def right(self) -> str:
        return "each joint's own column, as the model numbers the joints"

    def made(self, recording: Recording) -> Recording:
        return with_exchanged(recording, self.channels)


@dataclass(frozen=True)
class ReadAs(MapChange):
    """Inputs that go on otherwise between their rows."""

    held: str

    @property
    def kind(self) -> str:
        return "`held`"

    @property
    def done(self) -> str:
        return f'read with held = "{self.held}"'

    def made(self, recording: Recording) -> Recording:
        read = {n: replace(recording.channels[n], held=self.held) for n in self.channels}
        channels = {**recording.channels, **read}
        return replace(recording, map=replace(recording.map, channels=channels))


@dataclass(frozen=True)
class OwnZeros(MapChange):
    """A channel less what its sensor shows of nothing, which is another in each run [SI]."""

    zeros: tuple[tuple[str, float], ...]

    @property
    def kind(self) -> str:
        return OWN_ZERO

    @property
    def done(self) -> str:
        told = [zero for _, zero in self.zeros]
        return f"less {min(told):.3g} to {max(told):.3g} (SI), a zero of each run's own,"

    def made(self, recording: Recording) -> Recording:
        zeros = dict(self.zeros)

        def put_right(run: RecordedRun) -> RecordedRun:
            off = zeros.get(run.name, 0.0)
            changed = {n: run.channels[n] - off for n in self.channels if n in run.channels}
            return replace(run, channels={**run.channels, **changed})

        return replace(recording, runs=tuple(map(put_right, recording.runs)))


@dataclass(frozen=True)
class OnAxis(MapChange):
    """Positions freed from the wave that only their encoder shows."""

    off: OffAxis

    @property
    def kind(self) -> str:
        return OFF_AXIS

    @property
    def done(self) -> str:
        return f"less a wave of {self.off.size:.3g} rad once a turn"

    def made(self, recording: Recording) -> Recording:
        return replace(recording, runs=put_on_axis(recording.runs, self.off))


@dataclass(frozen=True)
class EvenSpeed(MapChange):
    """Speeds freed from a ripple that makes the same wave as an encoder off its axis."""

    off: OffAxis

    @property
    def kind(self) -> str:
        return RIPPLE

    @property
    def done(self) -> str:
        return f"less a ripple of {100.0 * self.off.size:.3g} % once a turn"

    def made(self, recording: Recording) -> Recording:
        return replace(recording, runs=put_even(recording.runs, self.off))
