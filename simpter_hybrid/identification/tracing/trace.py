"""Residuals along the coordinates on which they may depend, run by run."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

#: Samples are averaged in blocks of this length [s]; the noise of neighbours is then nearly white.
BLOCK = 0.01
#: Missing forces beyond this many standard deviations are instants, not dependences.
BOUND = 6.0
#: Coordinates of an axis along which something may be at one place only.
PLACE = ("position",)


@dataclass(frozen=True)
class Trace:
    """Residual of one run and the coordinates along it, all (samples,).

    `events`: the samples are events whose errors do not go on from one to the next; by chance they
    might have come in any other order.  `begins`: coordinates that begin at 0 again and again, each
    with the least value that can be told from 0; what happens there lasts so short that bins of
    equally many samples would hide it.  `local`: coordinates along which something may be at one
    place only (a bump, a detent, the joint of a rail).  `logged`: channels that no model reads.
    """

    residual: np.ndarray
    torque: np.ndarray
    coordinates: Mapping[str, np.ndarray]
    events: bool = False
    begins: Mapping[str, float] = field(default_factory=dict)
    local: tuple[str, ...] = ()
    logged: Mapping[str, np.ndarray] = field(default_factory=dict)

    def thinned(self, samples: int) -> Trace:
        """Means over blocks of `samples`; coordinates at the middle of each block."""
        count = self.residual.size // samples
        middle = np.arange(count) * samples + samples // 2
        along, logged = (
            {name: values[middle] for name, values in series.items()}
            for series in (self.coordinates, self.logged)
        )
        residual, torque = _block(self.residual, samples), _block(self.torque, samples)
        return replace(self, residual=residual, torque=torque, coordinates=along, logged=logged)


def force_trace(
    missing: np.ndarray,
    passed: np.ndarray,
    along: Mapping[str, np.ndarray],
    step: float,
    block: float = BLOCK,
    logged: Mapping[str, np.ndarray] | None = None,
    local: tuple[str, ...] = (),
) -> Trace:
    """A trace of a missing force: instants cut to size, then averaged over blocks.

    Parameters
    ----------
    missing, passed : ndarray (samples,)
        Missing force, and the force that goes through the friction [N or N m].
    along : mapping of str to ndarray (samples,)
        Coordinates on which it may depend.
    step, block : float
        Sample interval and length of a block [s].
    logged : mapping of str to ndarray (samples,), optional
        Channels that no model reads.
    local : tuple of str
        Coordinates along which something may be at one place only.
    """
    bound = BOUND * float(np.std(missing)) + 1e-30
    cut = np.clip(missing, -bound, bound)
    trace = Trace(cut, passed, along, logged=logged or {}, local=local)
    return trace.thinned(max(1, round(block / step)))


def _block(values: np.ndarray, samples: int) -> np.ndarray:
    count = values.size // samples
    return values[: count * samples].reshape(count, samples).mean(axis=1)
