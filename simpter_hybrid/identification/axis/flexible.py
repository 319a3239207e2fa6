"""An elastic part of a driven axis, and where fits of it begin.

What swings for long is found by a fit only from a frequency up to 4 % off.  So many are tried in
the recorded motion itself.  Let the drive and all friction alone accelerate an axis by ``f``; if
the part ``mu`` of its inertia hangs on a spring, it goes by ``f + mu / (1 - mu) H f``, where ``H``
is the high pass ``s^2 / (s^2 + 2 D W s + W^2)``, with ``W`` and ``D`` the frequency and damping of
the part while it is held over ``sqrt(1 - mu)``.  Nothing is simulated and nothing decided here.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache
from itertools import product
from typing import NamedTuple

import numpy as np
from scipy.integrate import cumulative_trapezoid
from scipy.optimize import minimize_scalar

from ...effects.flexible_mode import FlexibleMode
from ..fitting.replay import Replay
from ..recordings.row_step import row_step
from ..recordings.smoothing import derivative, smoothed, speed_width
from ..rigs.candidate import candidate
from ..rigs.effect_candidate import EffectCandidate
from ..tracing.swings import STANDS_OUT, strongest
from .candidates import of_axis, of_one_balance
from .position_waves import SLOW, orthonormal

#: A swing is looked for if it lasts this many rows, and is no slower than this [Hz].
ROWS, SLOWEST = 4.0, 0.5
#: So many frequencies in this range are tried in the recorded motion, each with these dampings.
TRIED, DAMPINGS = 60, (0.01, 0.03, 0.1, 0.3)
#: The best frequency is then found to this part of it.
CLOSE = 0.005
#: How often the drive's acceleration and the swinging part's are estimated in turn.
AGAIN = 2
#: Rows over which a recorded speed is differenced: what is faster is not seen in it.
ROWS_OF_SLOPE = 7
#: Most rows that are looked at.
LOOKED_AT = 20_000
#: Part of the inertia and damping with which a fit begins at a line of the recorded speed.
HUNG, DAMPED = 0.15, 0.03


class Flexible(NamedTuple):
    """Part of the inertia, its frequency [Hz] while the axis is held, its relative damping."""

    part: float
    frequency: float
    damping: float


class _Run(NamedTuple):
    acceleration: np.ndarray
    pushed: np.ndarray
    moving: np.ndarray
    step: float


def flexible_candidates(
    replays: Sequence[Replay], inertia: float, turning: bool, heaviest: float = 1.0
) -> tuple[EffectCandidate, ...]:
    """A part of the `inertia` on a spring; none where rows are too far apart to show one.

    A refit may find up to `heaviest` times as much: so much more may the part be.
    """
    step = max(row_step(r.time) for r in replays)
    highest = 1.0 / (ROWS * step)
    if highest <= 2.0 * SLOWEST:
        return ()
    shown = shown_by_motion(replays, min(highest, 1.0 / (ROWS_OF_SLOPE * step)))
    begins = [b for b in (shown, _line(replays, highest)) if b]
    return (flexible_mode(inertia, highest, begins, turning, heaviest),) if begins else ()


def flexible_mode(
    inertia: float, highest: float, begins: Sequence[Flexible], turning: bool,
    heaviest: float = 1.0,
) -> EffectCandidate:  # fmt: skip
    """The candidate, up to the `highest` frequency [Hz]."""
    made = candidate(
        "flexible-mode", FlexibleMode(coordinate=0),
        (("mass", 0.0, 0.95 * inertia * heaviest, 0.02 * inertia),
         ("frequency", 0.5 * SLOWEST, highest, 0.1), ("damping", 0.0, 1.0, 0.02)),
        tuple((b.part * inertia, b.frequency, b.damping) for b in begins),
        ("acceleration", "time", "displacement_since_reversal"),
    )  # fmt: skip
    return replace(of_one_balance(made), experiment=of_axis(made.experiment, turning))


def shown_by_motion(replays: Sequence[Replay], highest: float) -> Flexible | None:
    """Elastic part that explains most of the recorded acceleration, up to a frequency [Hz].

    None where no such part explains any of it.
    """
    seen = _Seen(_looked_at(replays))
    if seen.left.size <= seen.known.shape[1]:
        return None
    tried = list(product(np.geomspace(SLOWEST, highest, TRIED).tolist(), DAMPINGS))
    apart = (highest / SLOWEST) ** (1.0 / (TRIED - 1))
    ratio, best, passed = 0.0, tried[0], np.zeros(seen.left.size)
    for _ in range(AGAIN):
        alone = seen.driven_alone(ratio * passed)
        gains = [seen.explained(alone, *at)[0] for at in tried]
        near, damping = tried[int(np.argmax(gains))]
        tried = [(near, damping)]  # next time only around it
        best = seen.refined(alone, near, apart, damping), damping
        _, ratio, passed = seen.explained(alone, *best)
        if ratio <= 0.0:
            return None
    part = ratio / (1.0 + ratio)
    held = float(np.sqrt(1.0 - part))
    return Flexible(part, best[0] * held, best[1] * held)


class _Seen:
    """Rows in motion of some runs: what accelerates them in proportion to something, and the rest.

    `left` (rows,) is what all that is `known` (rows, k) leaves of the acceleration.
    """

    def __init__(self, runs: Sequence[_Run]) -> None:
        self.runs = runs
        self.acceleration = np.concatenate([r.acceleration[r.moving] for r in runs])
        self.known = np.concatenate([r.pushed[r.moving] for r in runs])
        self._basis = orthonormal(self.known)
        self.left = self._beyond_known(self.acceleration)

    def _beyond_known(self, values: np.ndarray) -> np.ndarray:
        return values - self._basis @ (self._basis.T @ values)

    def driven_alone(self, swung: np.ndarray) -> list[np.ndarray]:
        """Acceleration of each run that the drive alone would make, without the part that swings.

        `swung` (rows,) is the acceleration that the part makes.
        """
        size = np.linalg.lstsq(self.known, self.acceleration - swung, rcond=1e-9)[0]
        return [np.where(r.moving, r.pushed @ size, 0.0) for r in self.runs]

    def explained(
        self, alone: Sequence[np.ndarray], frequency: float, damping: float
    ) -> tuple[float, float, np.ndarray]:
        """What a part of this frequency and damping explains of the acceleration.

        Returns the sum of squares that it takes away, ``mu / (1 - mu)``, and ``H f`` (rows,).  Only
        what is in proportion to neither place nor speed counts: these swing as well.
        """
        passed = np.concatenate([
            _high_pass(f, r.step, frequency, damping)[r.moving]
            for f, r in zip(alone, self.runs, strict=True)
        ])  # fmt: skip
        beyond = self._beyond_known(passed)
        square = float(beyond @ beyond)
        ratio = float(beyond @ self.left) / square if square > 0.0 else 0.0
        return (ratio**2 * square if ratio > 0.0 else 0.0), ratio, passed

    def refined(
        self, alone: Sequence[np.ndarray], near: float, apart: float, damping: float
    ) -> float:
        """The frequency that explains most, up to the factor `apart` from one nearby."""

        def missed(frequency: float) -> float:
            return -self.explained(alone, frequency, damping)[0]

        within, close = (near / apart, near * apart), {"xatol": CLOSE * near}
        return float(minimize_scalar(missed, bounds=within, method="bounded", options=close).x)


def _looked_at(replays: Sequence[Replay]) -> list[_Run]:
    """Runs from the first on, the last of them cut, up to `LOOKED_AT` rows."""
    runs: list[_Run] = []
    rows = LOOKED_AT
    for replay in replays:
        if rows > ROWS_OF_SLOPE:
            runs.append(_run(replay, rows))
            rows -= runs[-1].moving.size
    return runs


def _run(replay: Replay, most: int) -> _Run:
    """Acceleration and all that may be in proportion to it, seen through the same difference."""
    step, rows = row_step(replay.time), slice(most)
    raw, place = replay.notes["speed"][rows], replay.notes["position"][rows]
    v = smoothed(raw, step, speed_width(step))
    width = ROWS_OF_SLOPE * step
    pushed = [np.sign(v), v, np.ones(v.size), place, v * np.abs(v), replay.inputs["drive"][rows]]
    seen = [derivative(cumulative_trapezoid(p, dx=step, initial=0.0), step, width) for p in pushed]
    moving = np.abs(v) > SLOW * float(np.quantile(np.abs(v), 0.9))
    return _Run(derivative(raw, step, width), np.column_stack(seen), moving, step)


def _high_pass(values: np.ndarray, step: float, frequency: float, damping: float) -> np.ndarray:
    from scipy.signal import lfilter

    return lfilter(*_high_pass_filter(step, frequency, damping), values)


@lru_cache(maxsize=4096)  # all that is tried is tried on each run
def _high_pass_filter(
    step: float, frequency: float, damping: float
) -> tuple[np.ndarray, np.ndarray]:
    from scipy.signal import bilinear

    rate = 2.0 / step * np.tan(np.pi * frequency * step)  # as the bilinear rule warps it
    return bilinear([1.0, 0.0, 0.0], [1.0, 2.0 * damping * rate, rate**2], 1.0 / step)


def _line(replays: Sequence[Replay], highest: float) -> Flexible | None:
    """Where a fit begins by the highest line in a recorded speed's spectrum; None without one."""
    lines = [strongest(r.notes["speed"], row_step(r.time)) for r in replays]
    told = [n for n in lines if n is not None and n.over >= STANDS_OUT and n.frequency < highest]
    if not told:
        return None
    free = max(told, key=lambda line: line.over).frequency
    return Flexible(HUNG, free * float(np.sqrt(1.0 - HUNG)), DAMPED)
