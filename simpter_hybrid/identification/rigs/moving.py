"""Whether the runs that fit, that select and that are held out move at all."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from ...problems import Problems
from ..fitting.replay import Replay
from ..recordings.channel_map import ChannelMap
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
    problems, rests = Problems(recording.source), {}
    for part in ("fit", "select", "report"):
        ways = np.array(
            [np.ptp(np.atleast_2d(run.notes["position"]), axis=1) for run in parts[part]]
        )
        if not (ways > far).any():
            rests[part] = ways.max(axis=0)
    other = _exchanged(recording, positions) if len(rests) == len(parts) else ""
    for part, most in rests.items():
        k = int(np.argmax(most / far))
        written = recording.channels[positions[k]].written_size
        names = ", ".join(run.name for run in parts[part])
        got = f"{_short(written(float(most[k])))} at most ({names})"
        right = (
            f"over {_short(written(float(far[k])))}, {MOVES:g} deviations of the noise of "
            f"{positions[k]}{_rounds(recording.channels[positions[k]], float(far[k]))}, for what "
            f"rests throughout tells no friction: another [split], or other `pieces`"
            f"{_until(parts[part])}{other}"
        )
        problems.add(("split", part), "no run of it moves as far as is asked", got, right)
    problems.raise_if_any()


def _until(runs: Sequence[Replay]) -> str:
    """Advice to leave out what follows a motion, where parts of a run are behind its end."""
    later = any(run.before is not None for run in runs)
    return ", or `until` under its [runs] if they have come to rest before they end" * later


def _short(written: str) -> str:
    """A number with its unit, in three digits."""
    number, _, unit = written.partition(" ")
    return f"{float(number):.3g} {unit}".strip()


def _rounds(channel: ChannelMap, far: float) -> str:
    """Words on the sensor's step, if rounding to it is all the noise that there is known of."""
    step = channel.step or 0.0
    if step <= 0.0 or far > MOVES * step:
        return ""
    return f" (its step is {_short(channel.written_size(step))})"


def _exchanged(recording: Recording, positions: Sequence[str]) -> str:
    """A question on the columns, where what drives moves like a position and that does not.

    Asked where no run at all moves: a column of one of few values, a relay's, has steps for noise.
    """
    if len(positions) > 1:
        return ""
    for name, channel in recording.channels.items():
        ways = [np.ptp(r.channels[name]) for r in recording.runs if name in r.channels]
        if channel.role == "input" and max(ways) > MOVES * channel_noise(recording, name):
            return f"; or are the columns of {positions[0]} and {name} exchanged?"
    return ""
