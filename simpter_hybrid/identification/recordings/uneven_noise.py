"""Positions of which most rows are known well and some jump, as those of a tracker do.

The noise of a channel is that of most of its rows (`noise`), so that corners of a motion do not
count: errors are told in times that, which no model comes near where a sensor jumps.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from .channel_map import ChannelMap
from .checks import Finding
from .lone_samples import EVEN, lone_samples
from .noise import own_noise
from .row_step import row_step

if TYPE_CHECKING:  # runs are checked while a recording is made of them
    from .recorded_run import RecordedRun

#: A third difference is a jump beyond so many deviations of what most rows' noise makes them.
FAR = 7.0
#: Jumps are told if they are this part of all differences (of noise that is even one in 4e11; of
#: five real rigs up to 0.0026 where a jump is no rounding) ...
OFTEN = 0.01
#: ... the largest of them is this part of the travel (where EMPS turns round they are 3e-6) ...
PART = 0.01
#: ... and each difference is followed by one the other way: over their square the product of
#: neighbours is -0.75 for one row that is off, -0.67 where all later rows are off alike, and of a
#: motion -0.5 for a sudden speed and 0 for a sudden force.  A slip that is over within a row is a
#: step as well, and nothing in the position tells it from a sensor's.
BACK = -0.6
#: Variance of third differences of white noise over its own.
THIRD = 20.0


class Jumps(NamedTuple):
    """What a position's third differences show: the noise of most rows and of all, and jumps.

    ``usual`` and ``all_rows`` are standard deviations [SI], ``part`` is that of rows at which one
    begins, ``row`` where the largest is.
    """

    usual: float
    all_rows: float
    part: float
    row: int


def jumps_of(time: np.ndarray, values: np.ndarray, channel: ChannelMap) -> Jumps | None:
    """Jumps of one run's position (samples,); None where there are none, or stamps are uneven."""
    if not np.isfinite(values).all() or values.size < 8:
        return None
    if np.any(np.abs(np.diff(time) / row_step(time) - 1.0) > EVEN):
        return None
    usual, third = own_noise(values, channel, time), np.diff(values, 3)
    square = float(third @ third)
    far = np.abs(third) > FAR * np.sqrt(THIRD) * usual
    if np.mean(far) < OFTEN or np.abs(third).max() < PART * np.ptp(values):
        return None
    if float(third[1:] @ third[:-1]) > BACK * square or lone_samples(time, values).size:
        return None  # the latter are told one by one
    every = float(np.sqrt(square / third.size / THIRD))
    return Jumps(usual, every, _jumps(third, far) / values.size, int(np.argmax(np.abs(third))) + 2)


def _jumps(third: np.ndarray, far: np.ndarray) -> int:
    """How many jumps third differences show, of which each makes three or four: their peaks."""
    size = np.abs(third)
    before, after = np.append(0.0, size[:-1]), np.append(size[1:], 0.0)
    return int(np.count_nonzero(far & (size >= before) & (size > after)))


def uneven_noise_remarks(
    runs: Sequence[RecordedRun], channels: Mapping[str, ChannelMap]
) -> Iterator[Finding]:
    """A remark on each measured position whose noise nobody told and of which some rows jump.

    Parameters
    ----------
    runs : sequence of RecordedRun
    channels : mapping of str to ChannelMap
    """
    for name, channel in channels.items():
        known = channel.noise is not None or channel.filter is not None
        if known or channel.role != "measured" or not name.startswith("position"):
            continue
        logged = [run for run in runs if name in run.channels]
        found = [(run, jumps_of(run.time, run.channels[name], channel)) for run in logged]
        jumping = [(run, jumps) for run, jumps in found if jumps is not None]
        if not jumping:
            continue
        run, most = max(jumping, key=lambda one: one[1].all_rows)
        where = f" (so in {len(jumping)} of {len(logged)} runs)" if len(logged) > 1 else ""
        usual, every = (f"{x / channel.unit_scale:.2g}{channel.suffix}" for x in most[:2])
        what = (
            f"noise of {name} is not even{where}: most rows have {usual}, and at "
            f"{100 * most.part:.2g} % the position jumps by far more, the most here"
        )
        right = (
            "even noise, or a slip that is over within a row, which looks alike: errors are told "
            "in times the noise of most rows, which no model comes near where a sensor jumps; then "
            f"`noise` in the map counts jumps too (all rows have {every})"
        )
        row, stamp = run.rows[0] + most.row, float(run.time[most.row])
        yield Finding(
            run.name, what, channel.written(run.channels[name][most.row]), right, row, stamp
        )
