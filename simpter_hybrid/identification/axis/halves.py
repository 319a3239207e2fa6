"""Halves of a run, where one has to fit and to select."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ...problems import InvalidInput, Problem
from ..fitting.replay import Observation, Replay, Restart
from ..recordings.runs import name_of_whole
from .signals import AxisSignals
from .windows import WINDOW


def halves(replay: Replay) -> tuple[Replay, Replay]:
    """First and second half of a run, where one run has to fit and to select.

    Raises
    ------
    InvalidInput
        If it is too short for two.
    """
    middle = middle_of(replay)
    if middle is None:
        right = (
            f"more than a window of {WINDOW:g} s ({2.0 * WINDOW:g} s where it is followed whole), "
            "for it both fits and selects; or other runs that select"
        )
        problem = Problem(replay.name, "", "too short", f"{replay.time[-1]:.3g} s", right)
        raise InvalidInput([problem])
    k = middle.index
    found: list[Replay] = []
    for span, first in ((slice(0, k), 0), (slice(k, None), k)):
        notes = {n: v if n == "start" else v[span] for n, v in replay.notes.items()}
        if first:
            notes["start"] = np.array([middle.position, middle.speed])
        restarts, followed = (
            tuple(
                replace(r, index=r.index - first)
                for r in anew
                if first < r.index < (k if first == 0 else replay.time.size)
            )
            for anew in (replay.restarts, replay.followed)
        )
        time = replay.time[span] - replay.time[first]
        observed = {c: _part(o, span) for c, o in replay.observed.items()}
        inputs = {c: v[span] for c, v in replay.inputs.items()}
        logged = {c: v[span] for c, v in replay.logged.items()}
        which, stamp = "second" if first else "first", replay.stamp + float(replay.time[first])
        before = found[0] if first else replay.before
        start_told = (False, False) if first else replay.start_told
        found.append(
            replace(replay, name=f"{replay.name}, {which} half", time=time, observed=observed,
                    inputs=inputs, restarts=restarts, followed=followed, notes=notes, logged=logged,
                    cut_from=name_of_whole(replay), stamp=stamp, before=before,
                    start_told=start_told)
        )  # fmt: skip
    return found[0], found[1]


def middle_of(replay: Replay) -> Restart | None:
    """Start of the second half of a run: of the window that begins nearest the middle.

    Of what is compared, in time: windows are of unequal lengths, and few.  A run that is one window
    is halved at its middle, or not at all (None) if it is too short for two.
    """
    if anew := replay.restarts or replay.followed:
        middle = _middle_compared(replay)
        return min(anew, key=lambda r: abs(float(replay.time[r.index]) - middle))
    if replay.time[-1] < 2.0 * WINDOW:
        return None
    k, s = replay.time.size // 2, AxisSignals()
    return Restart(k, float(replay.notes[s.position][k]), float(replay.notes[s.speed][k]))


def _middle_compared(replay: Replay) -> float:
    """Time halfway between the first and the last sample that is compared; of all if none is."""
    kept = [o.keep for o in replay.observed.values() if o.keep.any()]
    compared = replay.time[np.any(kept, axis=0)] if kept else replay.time
    return float(compared[0] + compared[-1]) / 2.0


def _part(seen: Observation, span: slice) -> Observation:
    """Cut an observation to `span`.

    Window starts are shifted; a cut with no window start is one window.
    """
    last = seen.values.size if span.stop is None else span.stop
    kept = [i for i, k in enumerate(seen.windows) if span.start <= k < last]
    windows = tuple(seen.windows[i] - span.start for i in kept) or (0,)
    cut = kept or [int(np.searchsorted(seen.windows, span.start, side="right")) - 1]
    slopes = tuple(seen.slopes[i] for i in cut) if seen.slopes else ()
    values, keep = seen.values[span], seen.keep[span]
    return replace(seen, values=values, keep=keep, windows=windows, slopes=slopes)
