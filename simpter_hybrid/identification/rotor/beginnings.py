"""How a rotor's runs begin, and what of them was not recorded.

A run is replayed from rest with nothing commanded.  Where the record begins later it says itself
how it began: the first command and reference are held for a while before it, so that lag and servo
are where these take them, and the motion is set from its first samples.  What cannot be known (what
the lag did before, histories) is left to settle before anything is compared; so is what follows a
gap, over which the inputs behind it are held.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ...scenario import Scenario
from ..fitting.replay import Restart
from ..recordings.checks import Finding
from ..recordings.recording import RecordedRun, Recording
from ..recordings.row_step import gaps, row_step
from .conditioning import FITTED, MEAN, RESTS_BELOW, Conditions, restart_at
from .idle_torque import idle_torque
from .signals import RotorSignals

#: The excitation has forgotten what it did before after so many time constants, and at least after
#: so long [s].
FORGETS, LEAST = 6.0, 0.1
#: Before a run that began earlier its first inputs are held for so many times the time to settle.
BEFORE = 3.0
#: A torque is carried at once if the mean of so many first samples is so many standard deviations.
AT_ONCE, CARRIED = 5, 6.0
#: Samples of the servo's torque at the start, and those that these are compared with: from rest the
#: servo kicks.
KICK, KICKED = 2, slice(3, 14)
#: A rotor that was at rest one row before has a first speed of no more than so many times what it
#: gains until the next row (more than once where what drives it falls meanwhile).
AT_MOST = 1.5
#: Part of a step by which the first stamp may be off one step after 0.
ROUNDING = 1e-3
#: Stamps that begin up to so many steps after 0 are those of a run from its start.
FIRST = 1.5
#: Digits of stamps behind the point [s].
DIGITS = 9


@dataclass(frozen=True)
class Beginning:
    """Stamps of one run as replayed, its restart at the start if any, and what is compared."""

    time: np.ndarray
    start: Restart | None
    keep: np.ndarray
    under_way: bool
    behind: tuple[int, ...]

    def applied_to(self, found: Conditions, run: RecordedRun, signals: RotorSignals, sd):
        """Conditions of a run driven by torque, with nothing that reaches across what is missing.

        Parameters
        ----------
        found : Conditions
        run : RecordedRun
        signals : RotorSignals
        sd : mapping of str to float
        """
        anew = {} if self.start is None else {0: self.start}
        for k in self.behind:
            anew[k] = _seen_at(k, run, signals, sd)
        if not anew:
            return found
        kept = {r.index: r for r in found.restarts if all(abs(r.index - k) > FITTED for k in anew)}
        every = kept | anew
        events = tuple(b for b in found.breakaways if self.keep[b.index])
        restarts = tuple(every[k] for k in sorted(every))
        return Conditions(restarts, events, found.keep & self.keep)


def settling(declared: Scenario) -> float:
    """Time after which nobody can tell what a clutch was commanded before [s]."""
    lags = [FORGETS * c.time_constant + c.delay for c in declared.clutches]
    return max(LEAST, *lags)


def beginning(
    run: RecordedRun,
    signals: RotorSignals,
    sd: Mapping[str, float],
    settles: float,
    zero: float = 0.0,
) -> Beginning:
    """How one run begins, and where it goes on behind a gap.

    Parameters
    ----------
    run : RecordedRun
    signals : RotorSignals
    sd : mapping of str to float
        Noise of its channels [SI].
    settles : float
        `settling` [s].
    zero : float
        What the torque's sensor shows of a clutch that is off: `idle_torque` [SI].
    """
    step = row_step(run.time)
    time, keep = _round(run.time), np.ones(run.time.size, bool)
    # From 0 s on to the first stamp the first inputs hold, for one row: no more, and no less.
    if abs(time[0] - step) > ROUNDING * step:
        time = _moved(time, step)
    behind = tuple((gaps(run.time) + 1).tolist())
    for k in behind:
        keep[k : k + round(settles / step)] = False
    under_way = began_earlier(run, signals, sd, zero)
    seen = _seen_at(0, run, signals, sd)
    if under_way:
        time = _moved(time, step * (1 + np.ceil(BEFORE * settles / step)))
        keep[: round(settles / step)] = False
    if not under_way and _starts(run, signals, sd):
        seen = Restart(0, float(run.channels[signals.position][0]), 0.0)
    start = seen if under_way or _elsewhere(run, signals, sd) else None
    return Beginning(time, start, keep, under_way, behind)


def began_earlier(
    run: RecordedRun, signals: RotorSignals, sd: Mapping[str, float], zero: float = 0.0
) -> bool:
    """Whether the first samples show what takes time to come from rest with nothing commanded.

    A torque that is carried at once, since the excitation lags; a motion that a torque drives;
    one that a servo drives and did not just start.  What the torque's sensor shows of a clutch that
    is off, its `zero`, is none.
    """
    carried = run.channels[signals.transmitted][:AT_ONCE]
    least = min(abs(carried.mean()), abs(carried.mean() - zero))
    if least > CARRIED * sd[signals.transmitted] / np.sqrt(carried.size):
        return True
    if _seen_at(0, run, signals, sd).speed == 0.0 or _starts(run, signals, sd):
        return False
    if np.isfinite(run.channels[signals.prescribed]).all():
        return True
    if signals.applied not in run.channels:
        return False  # then only what is carried is compared, and that is nothing yet
    applied = run.channels[signals.applied]
    kick = np.abs(applied[:KICK] - applied[KICKED].mean()).max()
    return bool(kick < CARRIED * sd[signals.applied])


def _starts(run: RecordedRun, signals: RotorSignals, sd: Mapping[str, float]) -> bool:
    """Whether a rotor that is fast soon after its first samples is at rest where the run begins.

    Samples may be so far apart that what it does between them does not show how a motion begins.
    At rest means: its first speed is within noise; or is no more than it gains in one step, and it
    is where it was, but for what it goes in one step.
    """
    speed, noise = run.channels[signals.speed], sd[signals.speed]
    first, soon = abs(float(speed[:KICK].mean())), abs(float(speed[KICKED].mean()))
    if soon <= CARRIED * noise:
        return False
    if first < RESTS_BELOW * noise / np.sqrt(KICK):
        return True
    gained = abs(float(speed[1] - speed[0]))
    return abs(float(speed[0])) <= AT_MOST * gained and not _elsewhere(run, signals, sd)


def _elsewhere(run: RecordedRun, signals: RotorSignals, sd: Mapping[str, float]) -> bool:
    """Whether a run begins at another position than 0, by more than it goes in one step.

    Only the first position counts: of a rotor that is thrown off at once later samples are no
    straight line, and say nothing of the first.
    """
    step = row_step(run.time)
    gone = float(np.abs(run.channels[signals.speed][:KICK]).max()) * step
    return bool(abs(run.channels[signals.position][0]) > RESTS_BELOW * sd[signals.position] + gone)


def inputs_by_time(time: np.ndarray, unit: float) -> tuple[np.ndarray, int]:
    """Sample whose inputs hold in each interval of `unit` [s] from 0, and how many precede it.

    An input holds up to its stamp: over a gap the one behind it, before the first sample the first.
    Stamps are those of a `Beginning`: the first is one `unit`, or some, after 0.
    """
    at = np.rint((time - time[0]) / unit).astype(int)
    before = max(0, round(float(time[0]) / unit) - 1)
    during = np.searchsorted(at, np.arange(at[-1] + 1))
    return np.concatenate([np.zeros(before, int), during]), before


def beginning_remarks(
    recording: Recording, signals: RotorSignals, sd: Mapping[str, float], settles: float
) -> tuple[Finding, ...]:
    """Remarks on runs that do not begin at rest at 0 s or have gaps, one for each kind."""
    zero = idle_torque(recording.runs, signals, settles)
    begun = [beginning(run, signals, sd, settles, zero) for run in recording.runs]
    steps = [row_step(run.time) for run in recording.runs]
    pairs = list(zip(recording.runs, begun, steps, strict=True))
    late = [run for run, _, step in pairs if not 0.0 <= run.time[0] < FIRST * step]
    under_way = [run for run, b, _ in pairs if b.under_way]
    holed = [run for run, b, _ in pairs if b.behind]
    blind = f"{settles:.2g} s are not compared"
    kinds = (
        (late, "stamps are counted from the start of the run", "a run that begins at 0 s"),
        (under_way, f"begins under way, as it was recorded; the first {blind}", "a run from rest"),
        (holed, f"inputs hold over a gap; behind it {blind}", "rows without a gap"),
    )
    return tuple(_remark(runs, what, right) for runs, what, right in kinds if runs)


def _round(time: np.ndarray) -> np.ndarray:
    """Stamps without errors of their last digits: see `_moved`."""
    rounded = np.round(time, DIGITS)
    return time if np.array_equal(time, rounded) else rounded


def _moved(time: np.ndarray, first: float) -> np.ndarray:
    """Stamps that begin at `first`, as round as they were.

    What is held changes at a stamp: one too large by its last digit would read what holds next.
    """
    return np.round(time - time[0] + first, DIGITS)


def _remark(runs: Sequence[RecordedRun], what: str, right: str) -> Finding:
    first = runs[0]
    value = f"{len(runs)} run{'s' if len(runs) > 1 else ''}"
    return Finding(first.name, what, value, right, first.rows[0], float(first.time[0]))


def _seen_at(k: int, run: RecordedRun, signals: RotorSignals, sd: Mapping[str, float]) -> Restart:
    """The motion at the start of sample `k`, from those behind it alone."""
    position, speed = run.channels[signals.position], run.channels[signals.speed]
    found = restart_at(k, position, speed, k - 1)
    rests = abs(found.speed) < RESTS_BELOW * sd[signals.speed] / np.sqrt(MEAN)
    return Restart(k, found.position, 0.0) if rests else found
