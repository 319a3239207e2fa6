"""How what drives an axis, and what presses it, goes on between rows of its record."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ..fitting.replay import Replay
from ..recordings.clocks import within_row
from ..recordings.recording import RecordedRun, Recording
from ..recordings.row_step import GAP

#: How an input goes on between its samples; of a drive in a replay's input ``holds``.
HOLDS = {"before": -1.0, "sampled": 0.0, "after": 1.0}
#: Steps of time that differ by no more than this part are even; if no more than the second part
#: of them are not, those are stalls.
EVEN, SELDOM = 0.1, 0.01
#: Input of a replay that says so of what presses; straight from row to row without it.
PRESS_HOLDS = "press holds"
#: Input of a replay that says so of whether the motor is released, where its map does.
RELEASE_HOLDS = "release holds"
#: Notes of a replay (samples,) by its inputs: how long after its rows' stamps one that is held
#: changes, by another clock [s].
SHIFTS = {"drive": "drive shift", "press": "press shift", "released": "release shift"}


def between(instants: np.ndarray, time: np.ndarray, values: np.ndarray, holds: float) -> np.ndarray:
    """Values of a sampled input at instants between its rows; `holds` is one of `HOLDS`."""
    if holds == HOLDS["sampled"]:
        return np.interp(instants, time, values)
    row = np.searchsorted(time, instants, side="right") - (holds == HOLDS["after"])
    return values[np.clip(row, 0, values.size - 1)]


def driving(instants: np.ndarray, time: np.ndarray, values: np.ndarray, holds: float) -> np.ndarray:
    """As `between`, for what drives: one that is not held goes smoothly through its rows.

    On the cubic through four rows (slopes of central differences; where rows are not even, of
    parabolas through three), but straight beside a gap: straight everywhere, EMPS was off by a
    tenth more in the run held out.  Where steps are uneven that seldom one is a stall of the
    logger, in which nobody knows what drove, and a gap as well.
    """
    straight = between(instants, time, values, holds)
    if holds != HOLDS["sampled"] or values.size < 4:
        return straight
    at = np.clip(np.searchsorted(time, instants, side="right") - 1, 1, values.size - 3)
    steps, rises = np.diff(time), np.diff(values)
    step, rise = steps[at], rises[at]
    part = (instants - time[at]) / step
    even = (np.abs(steps[at + k] - step) <= EVEN * step for k in (-1, 1))
    central = (0.5 * (rises[at + k] + rises[at + k + 1]) - rise for k in (-1, 0))
    slopes = (_slope(steps, rises, at + k) * step - rise for k in (0, 1))
    alike = np.logical_and(*even)
    before, after = (np.where(alike, x, y) for x, y in zip(central, slopes, strict=True))
    bent = part * (1.0 - part) * ((1.0 - part) * before - part * after)
    usual = np.median(steps)
    if np.mean(np.abs(steps - usual) > EVEN * usual) > SELDOM:
        pairs = [np.stack([step, steps[at + k]]) for k in (-1, 1)]
        alike = np.logical_and(*(x.max(axis=0) < GAP * x.min(axis=0) for x in pairs))
    smooth = np.logical_and.reduce([alike, part >= 0.0, part <= 1.0, np.isfinite(bent)])
    return np.where(smooth, straight + bent, straight)


def _slope(steps: np.ndarray, rises: np.ndarray, row: np.ndarray) -> np.ndarray:
    """Slope at rows of the parabolas through each and its two neighbours."""
    before, after = steps[row - 1], steps[row]
    return (after * rises[row - 1] / before + before * rises[row] / after) / (before + after)


def shifted(
    run: RecordedRun, recording: Recording, names: Mapping[str, str]
) -> dict[str, np.ndarray]:
    """The notes `SHIFTS` of a run; none of an input that changes at its rows' stamps.

    Parameters
    ----------
    run : RecordedRun
    recording : Recording
    names : mapping of str to str
        Inputs -> names of their channels.
    """
    there = {of: recording.channels[name] for of, name in names.items() if name in run.channels}
    late = {SHIFTS[of]: within_row(run.time, channel) for of, channel in there.items()}
    return {note: np.full(run.time.size, shift) for note, shift in late.items() if shift}


def shift_of(replay: Replay, name: str) -> float:
    """How long after its rows' stamps an input changes [s]."""
    note = SHIFTS[name]
    return float(replay.notes[note][0]) if note in replay.notes else 0.0


def presses(replay: Replay) -> float:
    """How the pressing input goes on between its rows: one of `HOLDS`."""
    held = replay.inputs.get(PRESS_HOLDS)
    return HOLDS["sampled"] if held is None else float(held[0])


def releases(replay: Replay) -> float:
    """How being released goes on between rows, one of `HOLDS`: as the drive, if nothing says so."""
    return float(replay.inputs.get(RELEASE_HOLDS, replay.inputs["holds"])[0])


def releasing(run: RecordedRun, recording: Recording, name: str) -> dict[str, np.ndarray]:
    """Whether the motor is released (samples,), and how that goes on between rows, if told."""
    ones = np.ones(run.time.size)
    if name not in run.channels:
        return {"released": 0.0 * ones}
    channel, released = recording.channels[name], {"released": 1.0 - run.channels[name]}
    told = {RELEASE_HOLDS: HOLDS[channel.held] * ones} if channel.held_stated else {}
    return released | told


def pressing(run: RecordedRun, recording: Recording, name: str) -> dict[str, np.ndarray]:
    """Pressing input of the friction surfaces (samples,), and how it goes on between rows."""
    ones = np.ones(run.time.size)
    held = recording.channels[name].held if name in run.channels else "sampled"
    return {"press": run.channels.get(name, 0.0 * ones), PRESS_HOLDS: HOLDS[held] * ones}
