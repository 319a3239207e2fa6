"""One axis: the recorded drive moves the declared model in windows set from the record.

An axis let alone follows its whole run: no noisy drive leads it astray, its start is fitted
(`rigs.free_start`), and a loss of energy shows the better the longer.
So does a servo with recorded set points, whose loop lets a false start fade.  Fits of both begin in
windows: what swings is soon half a period off.  A slider that a spring pulls is set anew in windows
again, and so is one that sticks and slips behind a servo without an integral: a slip that begins a
moment early has all later ones early, and neither remembers anything.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..fitting.replay import Observation, Replay, Restart
from ..recordings.course import course_of
from ..recordings.gaps import runs_between_gaps
from ..recordings.logged import told_of_run
from ..recordings.noise import channel_noise, noise_in, run_noise
from ..recordings.recording import RecordedRun, Recording
from ..recordings.row_step import row_step
from ..recordings.smoothing import rate_of_change, speed_width
from ..recordings.start import Start
from ..rigs.start_state import first_state
from .held_inputs import HOLDS, pressing, releasing, shifted
from .pieces import replayed
from .signals import AxisSignals
from .starts import BEGUN_UNTOLD, first_untold, start_states, told_starts
from .windows import (
    BENT_ROWS,
    CUBIC,
    WINDOW,
    bends_of,
    half_width,
    rows_untold,
    steepest,
    turns,
    window_starts,
)

#: A predicted state carries the error of its window's start: its samples are not independent.
WEIGHT = 0.3


def axis_replays(
    recording: Recording, signals: AxisSignals, groups: tuple[str, ...] = (),
    starts: Mapping[tuple[int, int], list[int]] | None = None,
) -> list[Replay]:  # fmt: skip
    """Replays of the runs of the given groups, in windows, in SI units.

    `starts` of windows by rows: those of the recording as it is, where this is a changed one.
    """
    chosen, every = (runs_between_gaps(recording, g, WINDOW) for g in (groups, ()))
    at = window_starts(recording, signals) if starts is None else starts
    return replayed(chosen, every, lambda run: _replay(run, recording, signals, at[run.rows]))


def _own_loop(run: RecordedRun, s: AxisSignals) -> bool:
    """Whether a servo runs its own loop: that holds a whole run, and a false start fades."""
    return not s.anew and s.reference in run.channels and not set(s.drive) & run.channels.keys()


def _let_alone(run: RecordedRun, s: AxisSignals) -> bool:
    """Whether nothing drove it."""
    return not {*s.drive, s.reference} & run.channels.keys()


@dataclass(frozen=True)
class _Seen:
    """A run as the signals of an axis show it.

    `told` are the rows that tell anything, `whole` is whether it is followed as a whole.
    """

    run: RecordedRun
    recording: Recording
    s: AxisSignals
    starts: Sequence[int]
    time: np.ndarray
    told: np.ndarray
    measured: bool
    alone: bool
    whole: bool

    @property
    def position(self) -> np.ndarray:
        return self.run.channels[self.s.position]

    def speed(self) -> np.ndarray:
        """As measured, or that of the positions."""
        if self.measured:
            return self.run.channels[self.s.speed]
        return rate_of_change(self.time, self.position, speed_width(row_step(self.time)))

    @property
    def cut(self) -> tuple[int, ...]:
        """Where windows of residuals begin."""
        return (0,) if self.whole else tuple(self.starts)


def _seen(
    run: RecordedRun, recording: Recording, s: AxisSignals, starts: Sequence[int]
) -> _Seen:  # fmt: skip
    time, alone = run.time - run.time[0], _let_alone(run, s)
    late = rows_untold(run, s)
    told = np.arange(time.size) >= next((k for k in starts if k >= late), late)
    return _Seen(
        run, recording, s, starts, time, told, s.speed in run.channels, alone,
        alone or _own_loop(run, s),
    )  # fmt: skip


def _replay(
    run: RecordedRun, recording: Recording, s: AxisSignals, starts: Sequence[int]
) -> Replay:
    seen = _seen(run, recording, s, starts)
    time, position = seen.time, seen.position
    rows = np.arange(time.size)
    speed = seen.speed()
    compared = _compared_speed(seen) if seen.measured else _compared_position(seen)
    name = s.speed if seen.measured else s.position
    bent = bends_of(run, s, recording.channels)
    notes = {s.position: position, s.speed: speed, **_shifted(run, recording, s)}
    told_start = recording.map.start if run.begins else Start()
    states, untold = _states(seen, speed, None if seen.measured else compared.sd, bent)
    if untold and seen.told[0] and not told_start.told[1]:
        notes[BEGUN_UNTOLD] = rows < untold
        compared = replace(compared, keep=seen.told & ~notes[BEGUN_UNTOLD])
    states[0] = told_start.put_right(states[0])
    restarts = tuple(Restart(k, *state) for k, state in zip(starts, states, strict=True))
    notes |= {"start": np.array(states[0]), BENT_ROWS: np.isin(rows, bent)}
    made = Replay(
        run.name, run.experiment, time, _inputs(run, recording, s), {name: compared}, restarts[1:],
        drive_is_exact=False, notes=notes, start_free=seen.alone and not seen.measured,
        start_told=told_start.told, **told_of_run(run, recording, s.all),
    )  # fmt: skip
    return replace(made, restarts=(), followed=restarts[1:]) if seen.whole else made


def _compared_speed(seen: _Seen) -> Observation:
    """A measured speed, as it is compared."""
    run, s = seen.run, seen.s
    # What noise of a sensed force does is weighed by itself; else neighbours go together.
    weight = 1.0 if seen.alone or s.sensed & run.channels.keys() else WEIGHT
    keep = run.compared(s.speed) & seen.told
    made = observed_speed(run, seen.recording, s.speed, weight, keep)
    return replace(made, windows=seen.cut, lines=False)


def _compared_position(seen: _Seen) -> Observation:
    """Positions, as they are compared where no speed was measured."""
    position, recording, s = seen.position, seen.recording, seen.s
    # A start's error moves a window by a straight line, which says nothing, but in a loop or
    # where what pulls depends on the place.
    # Of an encoder a run that mostly rests shows less than there is.
    sd = run_noise(position, recording.channels[s.position], seen.time)
    sd = max(sd, channel_noise(recording, s.position))
    lines = not (seen.whole or s.anew)
    most = steepest(position, seen.cut, half_width(row_step(seen.time)), sd) if lines else ()
    return Observation(position, sd, seen.told, 1.0, seen.cut, lines=lines, slopes=most)


def _states(
    seen: _Seen, speed: np.ndarray, sd: float | None, bent: np.ndarray
) -> tuple[list[tuple[float, float]], int]:
    """States in which windows start, and how many first rows tell nothing of the first of them.

    `sd` of the positions, if no speed was measured.
    """
    time, starts = seen.time, seen.starts
    place = course_of(seen.run, seen.recording, seen.s.position)
    untold = 0
    if sd is None or seen.whole:
        moves = course_of(seen.run, seen.recording, seen.s.speed) if sd is None else speed
        states = start_states(time, place, moves, starts, sd, bent)
    else:
        tells = told_starts(time, place, starts, sd, bent)
        states = [one.state for one in tells]
        untold = starts[1] if first_untold(tells, sd) else 0
    if seen.alone and sd is not None:
        states[0] = first_state(time, place, 2 * half_width(row_step(time)) + 1, sd, CUBIC)
    return states, untold


def as_if_recorded(replay: Replay, position: np.ndarray, speed: np.ndarray) -> Replay:
    """A run let alone as its record would be, had it moved so and no sensor any noise.

    Set anew where the run itself is, from states found in the same way.
    """
    derived = AxisSignals.position in replay.observed
    step = row_step(replay.time)
    if derived:
        speed = rate_of_change(replay.time, position, speed_width(step))
    starts = [r.index for r in replay.restarts or replay.followed]
    bent = turns(speed, 4 * half_width(step))
    sd = 0.0 if derived else None
    states = start_states(replay.time, position, speed, starts, sd, bent)
    restarts = tuple(Restart(k, *state) for k, state in zip(starts, states, strict=True))
    notes = {**replay.notes, AxisSignals.position: position, AxisSignals.speed: speed}
    return replace(replay, restarts=restarts, followed=(), notes=notes)


def observed_speed(
    run: RecordedRun, recording: Recording, name: str, weight: float, keep: np.ndarray
) -> Observation:
    """A measured speed; one that hardly changes is not taken for exact."""
    speed = run.channels[name]
    sd = max(noise_in(run, recording, name), 1e-3 * float(np.std(speed)) + 1e-12)
    return Observation(speed, sd, keep, weight)


def _inputs(run: RecordedRun, recording: Recording, s: AxisSignals) -> dict[str, np.ndarray]:
    """What drives the axis, in the units of its drive, and what its friction depends on."""
    name = next((d for d in (*s.drive, s.reference) if d in run.channels), None)
    ones = np.ones(run.time.size)
    pressed, power = pressing(run, recording, s.press), run.channels.get(s.supply, ones)
    if name is None:  # let alone: a motor that is there has open ends
        return {"drive": 0.0 * ones, "released": ones, "holds": 0.0 * ones, **pressed}
    return {
        "drive": run.channels[name] * (power if s.supplied(recording) else ones),
        "holds": HOLDS[recording.channels[name].held] * ones,
        **releasing(run, recording, s.engaged),
        **pressed,
    }


def _shifted(run: RecordedRun, recording: Recording, s: AxisSignals) -> dict[str, np.ndarray]:
    """How long after its rows' stamps each held input changes (samples,), if it does not there."""
    driving = next((d for d in (*s.drive, s.reference) if d in run.channels), "")
    return shifted(run, recording, {"drive": driving, "press": s.press, "released": s.engaged})
