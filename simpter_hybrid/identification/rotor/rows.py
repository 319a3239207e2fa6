"""A rotor's recording as its rig takes it: at the rate of rows for which breakaways are looked for.

Of a speed with another zero: a rotor that rests would be one that turns, and never break away.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

import numpy as np

from ..recordings.checks import Finding
from ..recordings.recorded_run import RecordedRun
from ..recordings.recording import Recording
from ..recordings.row_step import row_step
from ..recordings.speed_zero import less_zeros, speed_zeros
from .signals import RotorSignals

#: Time between rows [s]: slips, stops and levels are judged by some rows of this length.
ROW = 2e-3
#: Part of a row by which its time may be off.
ROUNDING = 1e-3
FAST = "rows come faster than a rotor needs"


def as_rotor(recording: Recording) -> Recording:
    """The recording as a rotor rig takes it: inputs held up to their stamps, and rows of `ROW`.

    An input that the map has held after its stamp is moved by a row, and the first row, of which
    nobody knows what held up to it, is left out.  Where rows come faster only
    every second, third ... is kept, by which its stamps count on.  A reference that was
    not logged, of a rig that is only driven by the other, applies in no row.  A zero of the speed
    that all runs show is taken off.
    """
    recording = _with_both_references(_with_zeros_off(recording))
    late = [n for n, c in recording.channels.items() if c.role == "input" and c.held == "after"]
    every = [_every(run) for run in recording.runs]
    if max(every) == 1 and not late:
        return recording
    channels = {
        name: replace(channel, held="before") if name in late else channel
        for name, channel in recording.channels.items()
    }
    runs = tuple(
        _thinned(_held_before(run, late), k) for run, k in zip(recording.runs, every, strict=True)
    )
    told = [_remark(run, k) for run, k in zip(runs, every, strict=True) if k > 1]
    return replace(
        recording, map=replace(recording.map, channels=channels), runs=runs,
        findings=(*recording.findings, *told[:1]),
    )  # fmt: skip


def _with_zeros_off(recording: Recording) -> Recording:
    """The recording with the `offset` in its map that `zero_remarks` tells of."""
    known = [(run.time, run.channels) for run in recording.runs]
    if not (zeros := list(speed_zeros(known, recording.channels))):
        return recording
    channels = {**recording.channels}
    for one in zeros:
        told = channels[one.speed]
        channels[one.speed] = replace(told, shift=told.shift - told.sign * one.zero)
    runs = tuple(
        replace(run, channels=right)
        for run, (_, right) in zip(recording.runs, less_zeros(known, zeros), strict=True)
    )
    return replace(recording, map=replace(recording.map, channels=channels), runs=runs)


def _remark(run: RecordedRun, every: int) -> Finding:
    right = f"about {ROW:g} s; an edge of the command is known to a row"
    return Finding(run.name, FAST, f"one of {every} is used", right, -1, np.nan)


def _held_before(run: RecordedRun, names: Collection[str]) -> RecordedRun:
    """The run with inputs that held from their stamps on as they were up to the next ones."""
    if not names:
        return run
    moved = {n: v[:-1] for n, v in run.channels.items() if n in names}
    rest = run.only(slice(1, None))
    return replace(rest, channels={**rest.channels, **moved})


def fast_rows(recording: Recording) -> tuple[Finding, ...]:
    """Remarks that `as_rotor` has made on rows left out."""
    return tuple(f for f in recording.findings if f.what == FAST)


def untold_holds(recording: Recording) -> tuple[Finding, ...]:
    """A remark on inputs whose map lets them go straight from row to row: a rotor's are held.

    A controller's output is.  A row too early or too late passes for another lag of the clutch.

    Parameters
    ----------
    recording : Recording
        As `as_rotor` hands it on.
    """
    inputs = [n for n in RotorSignals().inputs if n in recording.channels]
    told = [n for n in inputs if recording.channels[n].held == "sampled"]
    those = [n for n in told if any(_changes(run, n) for run in recording.runs)]
    if not those:
        return ()
    what = f"{', '.join(those)}: taken to hold up to the stamp of a row, as inputs of a rotor are"
    right = '`held = "before"`, if so; `held = "after"`, if a row holds from its stamp on'
    return (Finding.of_all(what, "not told by the map", right),)


def _changes(run: RecordedRun, name: str) -> bool:
    values = run.channels.get(name, np.zeros(0))
    return np.unique(values[np.isfinite(values)]).size > 1


def _every(run: RecordedRun) -> int:
    return max(1, int(ROUNDING + ROW / row_step(run.time)))


def _with_both_references(recording: Recording) -> Recording:
    """The recording in which a reference that is missing beside the other applies nowhere."""
    s, there = RotorSignals(), recording.channels
    pairs = ((s.prescribed, "N*m", s.inputs[0]), (s.inputs[0], "rad/s", s.prescribed))
    for name, unit, other in pairs:
        alone = name == s.prescribed or _throughout(recording)
        if name not in there and other in there and alone:
            made = replace(there[other], signal=name, unit=unit, scale=1.0, shift=0.0, times=1.0)
            runs = tuple(
                replace(run, channels={**run.channels, name: np.full(run.time.size, np.nan)})
                for run in recording.runs
            )
            described = replace(recording.map, channels={**there, name: made})
            return replace(recording, map=described, runs=runs)
    return recording


def _throughout(recording: Recording) -> bool:
    """Whether a torque drives the rotor in every row."""
    name = RotorSignals.prescribed
    return all(np.isfinite(run.channels.get(name, np.nan)).all() for run in recording.runs)


def _thinned(run: RecordedRun, every: int) -> RecordedRun:
    return run if every == 1 else run.only(slice(every - 1, None, every))
