"""Channels of a recording that its rig does not read, as they were logged."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import Any

import numpy as np

from .recording import RecordedRun, Recording

#: Of so many runs and more it is asked whether what differs from one to another goes with a logged
#: channel: of three one in three does in their order by chance.
ASKED_OF = 4


def told_of_run(
    run: RecordedRun, recording: Recording, used: Collection[str], rows: slice = slice(None)
) -> dict[str, Any]:
    """What a replay of any rig is told of its run beside what the rig reads: fields of `Replay`.

    Parameters
    ----------
    run : RecordedRun
    recording : Recording
        The whole that it is of.
    used : collection of str
        Signals that the rig reads.
    rows : slice
        Of the run.
    """
    return {
        "logged": _logged_beside(run, recording, used, rows),
        "setting": _setting_of(run, recording),
        "added": _added_of(run, recording),
        "cut_from": run.cut_from,
        "piece": run.piece,
    }


def _logged_beside(
    run: RecordedRun, recording: Recording, used: Collection[str], rows: slice
) -> Mapping[str, np.ndarray]:
    """Channels of one run that are not `used`; what is not in every row of every run is none.

    Nor is a constant of runs, which tells one from another and no more.
    """
    names = [n for n, c in recording.channels.items() if n not in used and c.role != "constant"]
    return {n: run.channels[n][rows] for n in names if _in_every_row(n, recording)}


def _setting_of(run: RecordedRun, recording: Recording) -> Mapping[str, float]:
    """Constants of a run (another load, another day): runs of another setting are no repetition."""
    names = [name for name, channel in recording.channels.items() if channel.role == "constant"]
    return {name: float(run.channels[name][0]) for name in names if name in run.channels}


def _added_of(run: RecordedRun, recording: Recording) -> Mapping[str, float]:
    """Parameter of the model -> what the run's constants add to it [SI]."""
    found: dict[str, float] = {}
    for name, channel in recording.channels.items():
        if channel.adds_to and name in run.channels:
            more = float(run.channels[name][0])
            found[channel.adds_to] = found.get(channel.adds_to, 0.0) + more
    return found


def _in_every_row(name: str, recording: Recording) -> bool:
    return all(name in r.channels and np.isfinite(r.channels[name]).all() for r in recording.runs)
