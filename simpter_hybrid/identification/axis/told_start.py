"""Whether runs begin as the map's ``[start]`` says."""

from __future__ import annotations

import numpy as np

from ...problems import InvalidInput, Problem
from ..recordings.checks import Finding
from ..recordings.noise import run_noise
from ..recordings.recorded_run import RecordedRun
from ..recordings.recording import Recording
from ..recordings.start import POSITION, SPEED
from ..rigs.start_state import first_state
from .windows import CUBIC, half_width

#: A told position is one of another zero if the first row is off by so many deviations of its
#: noise, and by this part of the way that the run goes.
OFF, PART = 10.0, 0.1
#: A told speed is doubted if the first rows are off by this part of the highest.
FASTER = 0.25
#: So many first rows tell a logged speed.
ROWS = 3


def told_start(recording: Recording) -> tuple[Finding, ...]:
    """Remarks on a told start: what begins faster or slower than that, or that no run uses it.

    Raises
    ------
    InvalidInput
        If runs begin elsewhere than was told.
    """
    start = recording.map.start
    if not any(start.told):
        return ()
    begun = [run for run in recording.runs if run.begins]
    if not begun:
        right = "runs whose first rows count, or no [start] in the map"
        what = "no run begins as the map says, for the first rows of all are left out"
        return (Finding("all runs", what, str(start), right, -1, float("nan")),)
    if start.position is not None:
        _refuse_elsewhere(recording, begun, start.position)
    if start.speed is None:
        return ()
    return tuple(f for run in begun if (f := _faster(recording, run, start.speed)) is not None)


def _refuse_elsewhere(recording: Recording, runs: list[RecordedRun], told: float) -> None:
    channel, problems = recording.channels[POSITION], []
    for run in runs:
        course = run.channels[POSITION]
        allowed = max(OFF * run_noise(course, channel, run.time), PART * float(np.ptp(course)))
        if abs(float(course[0]) - told) > allowed:
            got = channel.written_change(channel.sign * float(course[0]))
            right = channel.written_change(channel.sign * told)
            right += ", as [start] says (in the model's coordinate: behind sign and offset)"
            what = "the position begins elsewhere"
            problems.append(Problem(recording.source, run.name, what, got, right))
    if problems:
        raise InvalidInput(problems)


def _faster(recording: Recording, run: RecordedRun, told: float) -> Finding | None:
    """A remark where the first rows go by another speed."""
    speed = run.channels.get(SPEED)
    if speed is not None:
        read, channel = float(np.mean(speed[:ROWS])), recording.channels[SPEED]
        most = float(np.max(np.abs(speed)))
        written = channel.written_change(channel.sign * read)
    else:
        course, channel = run.channels[POSITION], recording.channels[POSITION]
        time = run.time - run.time[0]
        step = float(np.median(np.diff(time)))
        sd = run_noise(course, channel, run.time)
        read = first_state(time, course, 2 * half_width(step) + 1, sd, CUBIC)[1]
        most = float(np.max(np.abs(np.gradient(course, time))))
        written = f"{channel.written_change(channel.sign * read)}/s"
    if abs(read - told) <= FASTER * most:
        return None
    what, right = "does not begin with the speed that [start] tells", "no [start], if that is wrong"
    return Finding(run.name, what, written, right, run.rows[0], float(run.time[0]))
