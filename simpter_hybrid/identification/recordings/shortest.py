"""How long a run of an axis has to be, or a piece of one, and the half that each may give."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .row_step import row_step

if TYPE_CHECKING:
    from .recorded_run import RecordedRun
    from .recording import Recording

#: The longest run must last so long [s]: less is no motion, and mostly a wrong unit of time.
SHORTEST = 0.2
#: ... of an axis let alone, which is predicted whole: a small motor stops in a tenth of a second.
SHORTEST_ALONE = 0.02
#: ... in rows no nearer than this [s]: seconds at 100 Hz that are called milliseconds are.
FASTEST_ALONE = 5e-5
#: A run that both fits and selects lasts longer than its first window [s] (`axis/windows:WINDOW`);
#: one that is followed whole is cut at its middle, and each half lasts so long.
HALF = 0.5


#: A channel of each rig that is no single axis.
OTHERS = ("clutch_torque", "force_x", "position_2")


def of_one_axis(recording: Recording) -> bool:
    """Whether a recording is of one axis, in windows of which time is asked for."""
    return not any(name in recording.channels for name in OTHERS)


def longest_run(recording: Recording) -> RecordedRun:
    """The run, or piece, that lasts longest."""
    return max(recording.runs, key=lasts)


def lasts(run: RecordedRun) -> float:
    """Time from a run's first row to its last [s]."""
    return float(run.time[-1] - run.time[0])


def shortest(recording: Recording) -> float:
    """How long the longest run must last [s]."""
    slow = row_step(longest_run(recording).time) >= FASTEST_ALONE
    return SHORTEST_ALONE if slow and not recording.map.driven else SHORTEST


def most_pieces(recording: Recording) -> int:
    """Into how many pieces, long enough each, the longest run may be cut before it was cut."""
    run = longest_run(recording)
    step = row_step(run.time)  # between two pieces lies one
    return int((lasts(run) + step) * recording.map.pieces / (shortest(recording) + step))


def shortest_halved(recording: Recording) -> float:
    """How long a run must last that both fits and selects [s]."""
    return HALF if recording.map.driven else 2.0 * HALF
