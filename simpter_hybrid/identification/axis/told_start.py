"""Whether runs begin as the map's ``[start]`` says."""

from __future__ import annotations

import numpy as np

from ...problems import InvalidInput, Problem
from ..recordings.checks import Finding
from ..recordings.noise import run_noise
from ..recordings.recorded_run import RecordedRun
from ..recordings.recording import Recording
from ..recordings.row_step import row_step
from ..recordings.start import POSITION, SPEED
from ..rigs.start_state import first_told
from .windows import CUBIC, half_width

#: A told position is one of another zero if the first row is off by so many deviations of its
#: noise, and by this part of the way that the run goes.
OFF, PART = 10.0, 0.1
#: A told speed is doubted if that of the first rows is off by so many of its standard errors, and
#: by this part of the highest.
SURE, FASTER = 5.0, 0.03
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
    late = [run.name for run in recording.runs if not run.begins and run.piece <= 1]
    places = [] if start.position is None else _elsewhere(recording, begun, start.position)
    found = [f for run in begun if (f := _otherwise(recording, run, start.speed)) is not None]
    if late:
        right = "runs whose first rows count, or no [start] in the map"
        what = "the map's [start] is not used where a run's first rows are left out"
        found.append(Finding.of_all(what, ", ".join(late), right))
    return (*places, *found)


def _elsewhere(recording: Recording, runs: list[RecordedRun], told: float) -> list[Finding]:
    """Remarks on runs that begin elsewhere by more than noise; by much, that is refused."""
    channel, problems, found = recording.channels[POSITION], [], []
    if channel.summed:
        what, right = "a place is told, and no position was logged", "a channel called position"
        raise InvalidInput([Problem(recording.source, "start.position", what, f"{told:g}", right)])
    right = channel.written_size(told)
    right += ", as [start] says of every run (in the model's coordinate: behind sign and offset)"
    for run in runs:
        course = run.channels[POSITION]
        apart, noise = abs(float(course[0]) - told), run_noise(course, channel, run.time)
        got = channel.written_size(float(course[0]))
        if apart > max(OFF * noise, PART * float(np.ptp(course))):
            what = "the position begins elsewhere"
            problems.append(Problem(recording.source, run.name, what, got, right))
        elif apart > OFF * noise:
            where = run.rows[0], float(run.time[0])
            found.append(
                Finding(run.name, "begins elsewhere by more than noise", got, right, *where)
            )
    if problems:
        raise InvalidInput(problems)
    return found


def _otherwise(recording: Recording, run: RecordedRun, told: float | None) -> Finding | None:
    """A remark where the first rows go by another speed."""
    if told is None:
        return None
    speed = run.channels.get(SPEED)
    if speed is not None:
        channel, per = recording.channels[SPEED], ""
        read = float(np.mean(speed[:ROWS]))
        sd = run_noise(speed, channel, run.time) / np.sqrt(ROWS)
        most = float(np.max(np.abs(speed)))
    else:
        course, channel, per = run.channels[POSITION], recording.channels[POSITION], "/s"
        time = run.time - run.time[0]
        fewest = 2 * half_width(row_step(time)) + 1
        found = first_told(time, course, fewest, run_noise(course, channel, run.time), CUBIC)
        read, sd = found.speed, found.speed_sd
        most = float(np.max(np.abs(np.gradient(course, time))))
    if abs(read - told) <= SURE * sd + FASTER * most:
        return None
    what, right = "does not begin with the speed that [start] tells", "no [start], if that is wrong"
    written = f"{channel.written_size(read)}{per}"
    return Finding(run.name, what, written, right, run.rows[0], float(run.time[0]))
