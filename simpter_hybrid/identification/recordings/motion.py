"""Whether a recording moves: friction shows where something slips, and in noise nothing does."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from .channel_map import ChannelMap
from .checks import Finding
from .noise import run_noise
from .row_step import row_step

#: Means over this long [s], or this part of a run, are compared with the next ones: a longer mean
#: would take a single jerk for a motion.
SPAN, PART = 0.1, 0.02
#: They move if they differ by more than so many deviations that white noise would leave them, and
#: by one of the noise itself: slow noise is no motion either.
BEYOND = 6.0
#: A range of more deviations is motion, however fast: that of a million samples of noise is 10.
ALIVE = 12.0
#: A sensor may rest if this part of its rows repeat the one before.
RESTS = 0.05
#: Less than this part of the time in motion, or a range of so few deviations, shows little.
LEAST_PART, LEAST_RANGE = 0.05, 20.0


class Motion(NamedTuple):
    """Part of the time in motion, and the widest run's range in deviations of its noise."""

    part: float
    reach: float

    @property
    def none(self) -> bool:
        """Whether all of it may be noise."""
        return self.part == 0.0 and self.reach < ALIVE

    @property
    def little(self) -> bool:
        """Whether so little motion leaves most of what could be missing unseen."""
        return self.part < LEAST_PART or self.reach < LEAST_RANGE

    def __str__(self) -> str:
        if self.part < LEAST_PART:
            return f"in {100 * self.part:.2g} % of the time"
        return f"by {self.reach:.2g} standard deviations of its noise"


def motions(
    runs: Sequence[tuple[np.ndarray, Mapping[str, np.ndarray]]], channels: Mapping[str, ChannelMap]
) -> dict[str, Motion]:
    """How much each position moves, or the speed where no position was recorded.

    Parameters
    ----------
    runs : sequence of (ndarray (samples,), mapping of str to ndarray (samples,))
        Time stamps [s], and signal -> values [SI].
    channels : mapping of str to ChannelMap
    """
    found = {}
    for name, channel in channels.items():
        position = name.replace("speed", "position", 1)
        if not position.startswith("position") or channel.role == "constant":
            continue
        if name != position and position in channels:
            continue
        logged = [_of_run(time, seen[name], channel) for time, seen in runs if name in seen]
        if not logged:  # in none of the runs that are used
            continue
        moving, reach, sizes = (np.array(part) for part in zip(*logged, strict=True))
        found[name] = Motion(float(moving.sum() / sizes.sum()), float(reach.max()))
    return found


def little_motion(moved: Mapping[str, Motion], runs: int) -> list[Finding]:
    """What a reader must know of channels that hardly move; fatal where nothing moves at all."""
    still = bool(moved) and all(motion.none for motion in moved.values())
    right = f"motion in at least {100 * LEAST_PART:g} % of the time and over {LEAST_RANGE:g}"
    right += " deviations of the noise: these data show little of friction"
    if still:
        right = "a run in which something slips; are its columns and units the right ones?"
    return [
        Finding(
            f"all {runs} runs", f"{name} {'does not move' if still else 'hardly moves'}",
            f"motion {motion}", right, -1, float("nan"), still,
        )
        for name, motion in moved.items() if motion.little
    ]  # fmt: skip


def _of_run(time: np.ndarray, values: np.ndarray, channel: ChannelMap) -> tuple[int, float, int]:
    """Means that move, the run's range in deviations of its noise, how many means there are."""
    known = np.isfinite(values)
    time, values = time[known], values[known]
    if values.size < 2:
        return 0, 0.0, max(1, values.size)
    changes = np.abs(np.diff(values))
    # A sensor that rests jumps by single steps, whether the map states them or not; one that never
    # does may go any way between two rows.
    step = float(changes[changes > 0.0].min(initial=np.inf))
    step = step if np.mean(changes == 0.0) >= RESTS else np.inf
    noise = run_noise(values, channel, time)
    noise = max(noise, step / np.sqrt(12.0)) if np.isfinite(step) else noise
    seconds = max(SPAN, PART * float(time[-1] - time[0]))
    size = min(values.size // 2, max(1, round(seconds / row_step(time))))
    blocks = values[: values.size // size * size].reshape(-1, size)
    means = blocks.mean(axis=1)
    least = noise * max(1.0, BEYOND * np.sqrt(2.0 / size))
    apart = np.abs(means) if channel.signal.startswith("speed") else np.abs(np.diff(means))
    moving = (apart > least) | (np.ptp(blocks, axis=1)[: apart.size] > ALIVE * noise)
    return int(moving.sum()), float(np.ptp(values)) / noise, moving.size
