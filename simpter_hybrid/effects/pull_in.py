"""A gap that closes later and opens sooner than declared."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class PullIn(Effect):
    """Adds to the off-to-on delay and raises the level at which the clutch lets go.

    Parameters
    ----------
    extra : float
        Added to the delay from off to on [s].
    drop_out : float
        Added to the off threshold [V].
    """

    extra: float = parameter("time", 0.0, typical=0.01)
    drop_out: float = parameter("voltage", 0.0, low=0.0, typical=0.2)

    sizes: ClassVar[tuple[str, ...]] = ("extra", "drop_out")
    family: ClassVar[str] = "pull-in"
    acts_on: ClassVar[str] = "actuator"
    reveals: ClassVar[str] = "Steps from zero to several levels, and slow ramps down to zero."

    def changed_delay(self, delay: float) -> float:
        """The delay with ``extra`` [s]."""
        return max(0.0, delay + self.extra)

    def changed_threshold(self, threshold: float) -> float:
        """The threshold with ``drop_out`` [V]."""
        return threshold + self.drop_out
