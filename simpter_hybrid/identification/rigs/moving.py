"""Whether the runs that fit, that select and that are held out move at all."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from ...problems import Problems
from ..fitting.replay import Replay
from ..recordings.noise import channel_noise
from ..recordings.recording import Recording

#: A run moves if it goes so many deviations of its sensor's noise.
MOVES = 12.0


def check_moving(
    parts: Mapping[str, Sequence[Replay]], recording: Recording, positions: Sequence[str]
) -> None:
    """Check that a run that fits moves, one that selects, and one that is held out.

    Parameters
    ----------
    parts : mapping of str to sequence of Replay
    recording : Recording
    positions : sequence of str
        Signals of which the note ``position`` of the replays has a row each.

    Raises
    ------
    InvalidInput
        With each part of which no run moves.
    """
    far = np.array([MOVES * channel_noise(recording, name) for name in positions])
    problems = Problems(recording.source)
    for part in ("fit", "select", "report"):
        ways = [np.ptp(np.atleast_2d(run.notes["position"]), axis=1) for run in parts[part]]
        if not any((way > far).any() for way in ways):
            names = ", ".join(run.name for run in parts[part])
            right = "another [split], or other `pieces`: what rests throughout tells no friction"
            problems.add(("split", part), "no run of it moves", names, right)
    problems.raise_if_any()
