"""Inputs that change in some rows alone: readings of a slow logger, and steps of a driver.

Between readings nobody knows what a sensed drive did.  A driver's step is there at once, and not
along a slope that takes a row.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from .agreement import Runs
from .channel_map import ChannelMap
from .checks import Finding, stays
from .stuck import seen_by_a_sensor
from .told import TOLD

#: Fewest readings; most rows in each (longer ones are steps that were set), and fewest.
LEAST, LONGEST, SHORTEST = 12, 50, 3
#: Part of the readings that last as long as the usual one, within so many rows: clocks beat.
EVEN, ROWS = 0.7, 1
#: What a coarse sensor shows of a ramp goes on by its one step, but for rounding.
STEP = 1.01
#: Part of the readings that have a value of their own: what was set comes again.
OWN = 0.5
#: What a driver is told in so few rows, the first and last of a run left out, is told in steps.
SELDOM = 0.1
#: Steps of less than this part of its range are those of a ramp that was rounded.
ROUGH = 0.05


def stale_inputs(runs: Runs, channels: Mapping[str, ChannelMap]) -> list[Finding]:
    """Remarks on what drives and was sensed, such as a current that changes at every eighth row.

    Parameters
    ----------
    runs : sequence of (ndarray (samples,), mapping of str to ndarray (samples,))
        Time stamps [s], and signal -> values [SI].
    channels : mapping of str to ChannelMap
    """
    found = []
    for signal, channel in channels.items():
        there = [(time, values[signal]) for time, values in runs if signal in values]
        if not there or not seen_by_a_sensor(signal, channel):
            continue
        if (every := _read_at([values for _, values in there])) == 0:
            continue
        apart = every * float(np.median(np.concatenate([np.diff(time) for time, _ in there])))
        what = f"{signal} is read in one row of {every} alone: what it did between is not known"
        right = "a reading in every row; `held` in the map, if it did hold its value meanwhile"
        found.append(Finding.of_all(what, f"{1e3 * apart:.3g} ms", right))
    return found


def stepped_inputs(runs: Runs, channels: Mapping[str, ChannelMap]) -> list[Finding]:
    """Remarks on what a driver was told in steps, if the map lets it go straight between rows.

    Every level lasts some rows, and the next one is there a row later; a ramp is no step.

    Parameters
    ----------
    runs, channels
        As for `stale_inputs`.
    """
    found = []
    for signal, channel in channels.items():
        there = [values[signal] for _, values in runs if signal in values]
        there = [known for values in there if (known := values[np.isfinite(values)]).size > 2]
        told = signal.partition("_")[0] in TOLD
        if not there or not told or channel.role != "input" or channel.held_stated:
            continue
        inner = np.concatenate([stays(values)[1][1:-1] for values in there])
        jumps = np.abs(np.concatenate([np.diff(values[1:-1]) for values in there]))
        steps, rows = np.count_nonzero(jumps), sum(values.size for values in there)
        if not 0 < steps <= SELDOM * rows or inner.min(initial=SHORTEST) < SHORTEST:
            continue
        if jumps.max() < ROUGH * max(float(np.ptp(values)) for values in there):
            continue
        what = f"{signal} changes in steps, and its map lets it go on a slope from row to row"
        right = '`held = "after"`, if a row tells what drives from its stamp on (or "before")'
        found.append(Finding.of_all(what, f"{steps} of {rows} rows", right))
    return found


def _read_at(runs: Sequence[np.ndarray]) -> int:
    """At every how many rows there is a new reading; 0 if in (nearly) all, or if that varies."""
    lasts, levels = [], []
    for values in runs:
        starts, each = stays(values)
        lasts.append(each[1:-1])  # the first and the last may be cut
        levels.append(values[starts[1:-1]])
    readings, own = np.concatenate(lasts), np.concatenate(levels)
    if readings.size < LEAST:
        return 0
    every = int(np.median(readings))
    even = float(np.mean(np.abs(readings - every) <= ROWS))
    alone = np.unique(own).size / own.size
    jumps = np.abs(np.diff(own))
    least = float(jumps[jumps > 0.0].min(initial=np.inf))
    coarse = float(np.mean(jumps <= STEP * least)) >= OWN
    usual = SHORTEST <= every <= LONGEST and even >= EVEN and alone >= OWN
    return every if usual and not coarse else 0
