"""One axis: the recorded drive moves the declared model in windows set from the record.

An axis let alone follows its whole run: no noisy drive leads it astray, its start is fitted
(`rigs.free_start`), and a loss of energy shows the better the longer.
So does a servo with recorded set points, whose loop lets a false start fade.  Fits of both begin in
windows: what swings is soon half a period off.  A slider that a spring pulls is set anew in windows
again, and so is one that sticks and slips behind a servo without an integral: a slip that begins a
moment early has all later ones early, and neither remembers anything.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.signal import savgol_filter

from ..fitting.repeats import same_course
from ..fitting.replay import Observation, Replay, Restart
from ..recordings.gaps import runs_between_gaps
from ..recordings.logged import logged_beside, setting_of
from ..recordings.map_file import ChannelMap
from ..recordings.noise import channel_noise, run_noise
from ..recordings.recording import RecordedRun, Recording
from ..recordings.smoothing import derivative, local_fit, moving_mean, speed_width
from ..rigs.start_state import first_state, start_state
from .drive import LONGEST
from .held_inputs import HOLDS, pressing

#: Length of a free prediction: set anew from the record this often [s].
WINDOW = 0.5
#: Degree of the polynomial for a window's start: a parabola's slope is wrong where the speed turns.
CUBIC = 3
#: A predicted state carries the error of its window's start: its samples are not independent.
WEIGHT = 0.3


@dataclass(frozen=True)
class AxisSignals:
    """Signals of a recording of one axis; ``drive`` times ``supply``, where there is one.

    A drive of ``told`` is what a driver was told, not what a sensor saw: it has no noise.  Without
    any the ``reference`` drives: of the model's own position servo or of the end of its spring.
    `anew`: what follows it is set anew in windows.
    """

    position: str = "position"
    speed: str = "speed"
    drive: tuple[str, ...] = ("drive", "duty", "torque", "force", "current")
    told: tuple[str, ...] = ("drive", "duty", "supply", "reference")
    reference: str = "reference"
    supply: str = "supply"
    engaged: str = "torque_on"
    press: str = "pressure"
    anew: bool = False

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


def window_starts(
    recording: Recording, s: AxisSignals, held_out: Collection[str] = ()
) -> dict[tuple[int, int], list[int]]:
    """Samples at which the windows of every run start, by its rows.

    Repetitions have those of the first, so that what a model leaves of them can be compared; of
    the groups `held_out` none is the first of one that is not.
    """
    found: dict[tuple[int, int], list[int]] = {}
    firsts: list[RecordedRun] = []
    runs = runs_between_gaps(recording, (), WINDOW)
    for run in sorted(runs, key=lambda run: run.group in held_out):
        step = float(np.median(np.diff(run.time)))
        half = half_width(step)
        if (first := next((r for r in firsts if _repeats(run, r, s)), None)) is not None:
            found[run.rows] = [k for k in found[first.rows] if k == 0 or k < run.time.size - half]
            continue
        firsts.append(run)
        late = rows_untold(run, s)
        starts = list(range(late, max(late + 1, run.time.size - half), window_samples(step)))
        measured = s.speed in run.channels
        course = run.channels[s.speed if measured else s.position]
        places = smooth_places(course, starts, half if measured else 2 * half)
        found[run.rows] = [0, *places] if late else places
    return found


def rows_untold(run: RecordedRun, s: AxisSignals) -> int:
    """Rows at a run's start in which a late driver may still do what nobody has logged.

    What it was told before the record began; 0 of a short run, and of what a sensor saw.
    """
    if not {*s.drive} & {*s.told} & run.channels.keys():
        return 0
    rows = int(np.searchsorted(run.time, run.time[0] + LONGEST))
    return rows if run.time[-1] - run.time[0] > 2.0 * WINDOW else 0


def _repeats(run: RecordedRun, first: RecordedRun, s: AxisSignals) -> bool:
    """Whether a run was driven, and moved, as an earlier one."""
    own = (s.position, s.speed, *s.drive, s.supply, s.reference)
    one, other = ({k: v for k, v in r.channels.items() if k in own} for r in (run, first))
    return same_course(one, other)


def _own_loop(run: RecordedRun, s: AxisSignals) -> bool:
    """Whether a servo runs its own loop: that holds a whole run, and a false start fades."""
    return not s.anew and s.reference in run.channels and not set(s.drive) & run.channels.keys()


def _let_alone(run: RecordedRun, s: AxisSignals) -> bool:
    """Whether nothing drove it."""
    return not {*s.drive, s.reference} & run.channels.keys()


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
    measured, alone = s.speed in run.channels, _let_alone(run, s)
    told = np.arange(time.size) >= rows_untold(run, s)
    whole = alone or _own_loop(run, s)
    cut = (0,) if whole else tuple(starts)
    position = run.channels[s.position]
    speed = run.channels[s.speed] if measured else derivative(position, step, speed_width(step))
    if measured:
        # What noise of a sensed force does is weighed by itself; else neighbours go together.
        weight = 1.0 if alone or s.sensed & run.channels.keys() else WEIGHT
        seen = observed_speed(
            speed, recording.channels[s.speed], weight, run.compared(s.speed) & told
        )
        observed = {s.speed: replace(seen, windows=cut, lines=False)}
    else:
        # A start's error moves a window by a straight line, which says nothing, but in a loop or
        # where what pulls depends on the place.
        # Of an encoder a run that mostly rests shows less than there is.
        sd = run_noise(position, recording.channels[s.position])
        sd = max(sd, channel_noise(recording, s.position))
        lines = not (whole or s.anew)
        observed = {s.position: Observation(position, sd, told, 1.0, cut, lines=lines)}
    states = _states(position, speed, starts, step, None if measured else sd)
    if alone and not measured:
        states[0] = first_state(time, position, 2 * half_width(step) + 1, sd, CUBIC)
    restarts = tuple(Restart(k, *state) for k, state in zip(starts, states, strict=True))
    notes = {s.position: position, s.speed: speed, "start": np.array(states[0])}
    made = Replay(
        run.name, run.experiment, time, _inputs(run, recording, s), observed, restarts[1:],
        told=False, notes=notes, logged=logged_beside(run, recording, s.all),
        setting=setting_of(run, recording), start_free=alone and not measured,
    )  # fmt: skip
    return replace(made, restarts=(), followed=restarts[1:]) if whole else made


def _states(
    position: np.ndarray, speed: np.ndarray, starts: Sequence[int], step: float, sd: float | None
) -> list[tuple[float, float]]:
    """Position and speed at each start; `sd` of the positions, if no speed was measured."""
    half = half_width(step)
    if sd is not None:
        return [start_state(position, k, 2 * half, step, sd, CUBIC) for k in starts]
    spans = ((slice(max(0, k - half), k + half + 1), min(k, half)) for k in starts)
    return [(local_fit(position[span], at), local_fit(speed[span], at)) for span, at in spans]


def as_if_recorded(replay: Replay, position: np.ndarray, speed: np.ndarray) -> Replay:
    """A run let alone as its record would be, had it moved so and no sensor any noise.

    Set anew where the run itself is, from states found in the same way.
    """
    step = float(np.median(np.diff(replay.time)))
    derived = AxisSignals.position in replay.observed
    if derived:
        speed = derivative(position, step, speed_width(step))
    starts = [r.index for r in replay.restarts or replay.followed]
    states = _states(position, speed, starts, step, 0.0 if derived else None)
    restarts = tuple(Restart(k, *state) for k, state in zip(starts, states, strict=True))
    notes = {**replay.notes, AxisSignals.position: position, AxisSignals.speed: speed}
    return replace(replay, restarts=restarts, followed=(), notes=notes)


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
    pressed = pressing(run, recording, s.press)
    if name is None:  # let alone: a motor that is there has open ends
        return {"drive": 0.0 * ones, "released": ones, "holds": 0.0 * ones, **pressed}
    return {
        "drive": run.channels[name] * run.channels.get(s.supply, ones),
        "released": 1.0 - run.channels.get(s.engaged, ones),
        "holds": HOLDS[recording.channels[name].held] * ones,
        **pressed,
    }
