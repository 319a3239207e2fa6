"""Rows of an axis that is let alone from before it was let go: somebody held it there.

What rests with nothing acting on it does not begin to move: so much is sure of any model.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from .channel_map import ChannelMap
from .checks import Finding
from .noise import run_noise
from .recorded_run import RecordedRun

#: A row has moved if it is so many deviations of the noise off the mean of the first rows.
MOVED = 6.0
#: Number of these first rows, and of rows in turn that must have moved.
FIRST, RUNNING = 9, 3
#: A shorter rest [s] is taken for the slow begin of a free motion.
LEAST = 0.15
#: Rows move before that if their slope is so many of its standard deviations: what swings through
#: its middle is fastest there, and sampled slowly it seems to rest ...
STEADY = 4.0
#: ... and if they go by so many deviations of the noise on the whole, unlike a hand that creeps or
#: an encoder that counts once.
FAR = 3.0
#: So many instants are tried at which the axis may have been let go; a rest until then must lower
#: what is left by the square of so many deviations.
TRIED, SURE = 60, 3.0
#: Remark on rows that are left out.
HELD = "rests before it moves, and nothing acts on it: rows from before it was let go are left out"


def let_go(
    runs: Sequence[RecordedRun],
    channels: Mapping[str, ChannelMap],
    signal: str,
) -> tuple[list[RecordedRun], list[Finding]]:
    """Runs from where they begin to move, and remarks on what was left out.

    Parameters
    ----------
    runs : sequence of RecordedRun
        Nothing drives them, and nothing that changes presses.
    channels : mapping of str to ChannelMap
    signal : str
        Position or speed by which that is told.
    """
    made, found = [], []
    moved = False
    for k, run in enumerate(runs):
        # What another piece leads up to is in motion, if that one was.
        goes_on = moved and run.goes_on(runs[k - 1])
        moved = goes_on or signal not in run.channels or _moves(run, channels[signal], signal)
        if goes_on or signal not in run.channels:  # which is told where it is needed
            made.append(run)
            continue
        course = run.channels[signal]
        noise = run_noise(course, channels[signal], run.time)
        # A steady speed is no rest: what coasts down slowly hardly changes it for long.
        rests = signal.startswith("position") or abs(np.mean(course[:FIRST])) <= MOVED * noise
        begins = _begins(course, noise) if rests else 0
        rested = float(run.time[begins] - run.time[0])
        if rested < LEAST:
            made.append(run)
            continue
        made.append(_from(run, begins))
        right = "runs that begin when they are let go, as [runs] boundaries or the file has them"
        where = run.rows[0], float(run.time[0])
        found.append(Finding(run.name, HELD, f"{rested:.3g} s", right, *where))
    return made, found


def _moves(run: RecordedRun, channel: ChannelMap, signal: str) -> bool:
    """Whether a run moves at all, by far more than its noise."""
    course = run.channels[signal]
    return bool(np.ptp(course) > 2.0 * MOVED * run_noise(course, channel, run.time))


def _begins(course: np.ndarray, noise: float) -> int:
    """The first row that has moved, with those after it; 0 if none has, or hardly any are left."""
    off = np.abs(course - np.mean(course[:FIRST])) > MOVED * noise
    if course.size < 2 * FIRST or off[:FIRST].any():
        return 0
    moved = np.flatnonzero(np.convolve(off, np.ones(RUNNING), "valid") == RUNNING)
    begins = int(moved[0]) if moved.size else 0
    if _slopes(course[: max(FIRST, 2 * begins // 3)], noise):
        return 0
    if begins and _turns(course[: begins + RUNNING], noise):
        return 0
    return begins if course.size - begins > 2 * FIRST else 0


def _slopes(course: np.ndarray, noise: float) -> bool:
    """Whether rows go one way by more than noise makes them: then they do not rest."""
    index = np.arange(course.size) - 0.5 * (course.size - 1)
    size = float(np.linalg.norm(index))
    goes = abs(float(index @ course)) / size**2 * course.size
    return goes > FAR * noise and goes > STEADY * noise / size * course.size


def _turns(course: np.ndarray, noise: float) -> bool:
    """Whether the course may have left its first row faster and faster, as it does behind a turn.

    False if a rest before the motion explains the rows better, by more than noise would.
    """
    index = np.arange(course.size, dtype=float)
    begins = np.unique(np.linspace(0, course.size - RUNNING, TRIED).astype(int))
    goes = np.maximum(index - begins[:, None], 0.0) ** 2
    goes -= goes.mean(axis=1, keepdims=True)
    explained = (goes @ (course - course.mean())) ** 2 / np.sum(goes**2, axis=1)
    return bool(explained[0] >= explained.max() - (SURE * noise) ** 2)


def _from(run: RecordedRun, row: int) -> RecordedRun:
    return replace(run.only(slice(row, None)), rows=(run.row(row), run.rows[1]))
