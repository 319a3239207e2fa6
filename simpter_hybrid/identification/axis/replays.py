"""One driven axis: the recorded drive moves the declared model in windows set from the record."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.signal import savgol_filter

from ...problems import InvalidInput, Problem
from ..fitting.repeats import same_course
from ..fitting.replay import Observation, Replay, Restart
from ..recordings.gaps import runs_between_gaps
from ..recordings.logged import logged_beside
from ..recordings.map_file import ChannelMap
from ..recordings.noise import channel_noise, run_noise
from ..recordings.recording import RecordedRun, Recording
from ..recordings.smoothing import derivative, local_fit, moving_mean, speed_width
from ..rigs.start_state import start_state

#: Length of a free prediction: set anew from the record this often [s].
WINDOW = 0.5
#: Degree of the polynomial for a window's start: a parabola's slope is wrong where the speed turns.
CUBIC = 3
#: How a drive goes on between its samples, in a replay's input ``holds``.
HOLDS = {"before": -1.0, "sampled": 0.0, "after": 1.0}
#: A predicted state carries the error of its window's start: its samples are not independent.
WEIGHT = 0.3


@dataclass(frozen=True)
class AxisSignals:
    """Signals of a recording of one axis; ``drive`` times ``supply``, where there is one.

    A drive of ``told`` is what a driver was told, not what a sensor saw: it has no noise.  Without
    any the ``reference`` of the model's own position servo drives.
    """

    position: str = "position"
    speed: str = "speed"
    drive: tuple[str, ...] = ("drive", "duty", "torque", "force", "current")
    told: tuple[str, ...] = ("drive", "duty", "supply", "reference")
    reference: str = "reference"
    supply: str = "supply"
    engaged: str = "torque_on"
    press: str = "pressure"

    @property
    def all(self) -> tuple[str, ...]:
        """Names of all that is used."""
        rest = self.supply, self.engaged, self.press, self.reference
        return (self.position, self.speed, *self.drive, *rest)

    @property
    def sensed(self) -> frozenset[str]:
        """What drives the axis and was seen by a sensor."""
        return frozenset(self.drive) - frozenset(self.told)


def axis_replays(
    recording: Recording, signals: AxisSignals, groups: tuple[str, ...] = (),
    starts: Mapping[tuple[int, int], list[int]] | None = None,
) -> list[Replay]:  # fmt: skip
    """Replays of the runs of the given groups, in windows of `WINDOW`, in SI units.

    `starts` of windows by rows: those of the recording as it is, where this is a changed one.
    """
    chosen = runs_between_gaps(recording, groups, WINDOW)
    at = window_starts(recording, signals) if starts is None else starts
    return [_replay(run, recording, signals, at[run.rows]) for run in chosen]


def window_starts(recording: Recording, s: AxisSignals) -> dict[tuple[int, int], list[int]]:
    """Samples at which the windows of every run start, by its rows.

    Repetitions have those of the first, so that what a model leaves of them can be compared.
    """
    found: dict[tuple[int, int], list[int]] = {}
    firsts: list[RecordedRun] = []
    for run in runs_between_gaps(recording, (), WINDOW):
        step = float(np.median(np.diff(run.time)))
        half = half_width(step)
        if (first := next((r for r in firsts if _repeats(run, r, s)), None)) is not None:
            found[run.rows] = [k for k in found[first.rows] if k == 0 or k < run.time.size - half]
            continue
        firsts.append(run)
        last = 1 if _own_loop(run, s) else run.time.size - half
        starts = list(range(0, max(1, last), window_samples(step)))
        measured = s.speed in run.channels
        course = run.channels[s.speed if measured else s.position]
        found[run.rows] = smooth_places(course, starts, half if measured else 2 * half)
    return found


def _repeats(run: RecordedRun, first: RecordedRun, s: AxisSignals) -> bool:
    """Whether a run was driven, and moved, as an earlier one."""
    own = (s.position, s.speed, *s.drive, s.supply, s.reference)
    alike = [{k: v for k, v in r.channels.items() if k in own} for r in (run, first)]
    return same_course(*alike)


def _own_loop(run: RecordedRun, s: AxisSignals) -> bool:
    """Whether a servo runs its own loop: that holds a whole run, and a false start fades."""
    return s.reference in run.channels and not set(s.drive) & run.channels.keys()


def window_samples(step: float) -> int:
    """Samples of a window: half a second, or eight where they are few."""
    return max(8, round(WINDOW / step))


def half_width(step: float) -> int:
    """Samples on either side from which a start's speed is fitted."""
    return max(3, round(0.5 * speed_width(step) / step))


def _replay(
    run: RecordedRun, recording: Recording, s: AxisSignals, starts: Sequence[int]
) -> Replay:
    time = run.time - run.time[0]
    step = float(np.median(np.diff(time)))
    half, measured = half_width(step), s.speed in run.channels
    position = run.channels[s.position]
    speed = run.channels[s.speed] if measured else derivative(position, step, speed_width(step))
    if measured:
        # What noise of a sensed force does is weighed by itself; else neighbours go together.
        weight = 1.0 if s.sensed & run.channels.keys() else WEIGHT
        seen = observed_speed(speed, recording.channels[s.speed], weight, run.compared(s.speed))
        observed = {s.speed: replace(seen, windows=tuple(starts), lines=False)}
        states = [
            (local_fit(position[span], at), local_fit(speed[span], at))
            for span, at in ((slice(max(0, k - half), k + half + 1), min(k, half)) for k in starts)
        ]
    else:
        # A start's error moves a window by a straight line, which says nothing, but in a loop.
        # Of an encoder a run that mostly rests shows less than there is.
        sd = run_noise(position, recording.channels[s.position])
        sd = max(sd, channel_noise(recording, s.position))
        keep = np.ones(time.size, bool)
        seen = Observation(position, sd, keep, 1.0, tuple(starts), lines=not _own_loop(run, s))
        observed = {s.position: seen}
        states = [start_state(position, k, 2 * half, step, sd, CUBIC) for k in starts]
    restarts = tuple(Restart(k, *state) for k, state in zip(starts, states, strict=True))
    notes = {s.position: position, s.speed: speed, "start": np.array(states[0])}
    return Replay(
        run.name, run.experiment, time, _inputs(run, recording, s), observed, restarts[1:],
        told=False, notes=notes, logged=logged_beside(run, recording, s.all),
    )  # fmt: skip


def smooth_places(course: np.ndarray, starts: Sequence[int], half: int) -> list[int]:
    """Where windows are to start: near `starts`, but for the first, where a cubic fits best.

    Beside a stop or a reversal friction bends the course, and no fit tells the speed there.
    """
    width = 2 * half + 1
    if len(starts) < 2 or course.size < width:
        return list(starts)
    misfit = moving_mean((course - savgol_filter(course, width, CUBIC)) ** 2, width)
    reach = (starts[1] - starts[0]) // 4
    best = [k - reach + int(np.argmin(misfit[k - reach : k + reach + 1])) for k in starts[1:]]
    return [starts[0], *best]


def observed_speed(
    speed: np.ndarray, channel: ChannelMap, weight: float, keep: np.ndarray
) -> Observation:
    """A measured speed; one that hardly changes is not taken for exact."""
    sd = max(run_noise(speed, channel), 1e-3 * float(np.std(speed)) + 1e-12)
    return Observation(speed, sd, keep, weight)


def _inputs(run: RecordedRun, recording: Recording, s: AxisSignals) -> dict[str, np.ndarray]:
    """What drives the axis, in the units of its drive, and what its friction depends on."""
    name = next((d for d in (*s.drive, s.reference) if d in run.channels), None)
    ones = np.ones(run.time.size)
    press = run.channels.get(s.press, 0.0 * ones)
    if name is None:  # let alone: a motor that is there has open ends
        return {"drive": 0.0 * ones, "released": ones, "press": press, "holds": 0.0 * ones}
    return {
        "drive": run.channels[name] * run.channels.get(s.supply, ones),
        "released": 1.0 - run.channels.get(s.engaged, ones),
        "press": press,
        "holds": HOLDS[recording.channels[name].held] * ones,
    }


def halves(replay: Replay) -> tuple[Replay, Replay]:
    """First and second half of a run, where one run has to fit and to select.

    Raises
    ------
    InvalidInput
        If it is too short for two.
    """
    middle = middle_of(replay)
    if middle is None:
        right = f"more than a window of {WINDOW:g} s, or other runs that select"
        problem = Problem(replay.name, "", "too short", f"{replay.time[-1]:.3g} s", right)
        raise InvalidInput([problem])
    k = middle.index
    found = []
    for span, first in ((slice(0, k), 0), (slice(k, None), k)):
        notes = {n: v if n == "start" else v[span] for n, v in replay.notes.items()}
        if first:
            notes["start"] = np.array([middle.position, middle.speed])
        restarts = tuple(
            replace(r, index=r.index - first) for r in replay.restarts
            if first < r.index < (k if first == 0 else replay.time.size)
        )  # fmt: skip
        time = replay.time[span] - replay.time[first]
        observed = {
            c: replace(o, values=o.values[span], keep=o.keep[span], windows=_within(o, span))
            for c, o in replay.observed.items()
        }
        inputs = {c: v[span] for c, v in replay.inputs.items()}
        logged = {c: v[span] for c, v in replay.logged.items()}
        which = "second" if first else "first"
        found.append(
            replace(replay, name=f"{replay.name}, {which} half", time=time, observed=observed,
                    inputs=inputs, restarts=restarts, notes=notes, logged=logged)
        )  # fmt: skip
    return found[0], found[1]


def middle_of(replay: Replay) -> Restart | None:
    """Where a run is halved: at its middle window, or where it is one, if that holds two."""
    if replay.restarts:
        return replay.restarts[len(replay.restarts) // 2]
    if replay.time[-1] < 2.0 * WINDOW:
        return None
    k, s = replay.time.size // 2, AxisSignals()
    return Restart(k, float(replay.notes[s.position][k]), float(replay.notes[s.speed][k]))


def _within(seen: Observation, span: slice) -> tuple[int, ...]:
    """Starts of windows in a part that begins with one."""
    last = seen.values.size if span.stop is None else span.stop
    return tuple(k - span.start for k in seen.windows if span.start <= k < last) or (0,)
