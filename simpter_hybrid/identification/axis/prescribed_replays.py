"""Replays of a coordinate that is moved from outside: its motion, and which rows are compared."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..fitting.replay import Observation, Replay
from ..recordings.logged import told_of_run
from ..recordings.noise import channel_noise, coarse_step, noise_estimate, noise_in, seen_step
from ..recordings.recording import RecordedRun, Recording
from ..recordings.row_step import gaps, row_step
from .force_sensor import LONGEST
from .held_inputs import pressing, shifted
from .pieces import replayed
from .position_motion import motion_of

#: Slower than this part of the usual speed a row is compared only in the midst of a steady stroke
#: (`AROUND` before and after it): friction may there have any value up to breakaway.
SLOW = 0.2
#: Time around a row that must be steady, and near a pause of the recorder or a run's start in which
#: no row is compared [s].
AROUND = 0.15
#: The motion is set no oftener than this [s], and no more than so many times in a run.
SET, MOST = 0.002, 12_000
#: A pressure jumps if it changes by more than this part of its range from one row to the next.
JUMP = 0.05
#: Note of a replay: whether its measured force has less noise than what inertia makes of positions.
CLEARER = "clearer"
#: Note of a replay: number of the first reason for which a row is not compared; and the reasons.
WHY = "why"
JUMPS = "where the position bends too fast for its rows, or jumps"
REASONS = (
    f"within {AROUND:g} s of an end or a pause", "at rest or slow", "at a turn", JUMPS,
    "after a jump of the pressure", "beyond the map's limits, or far outside all else",
)  # fmt: skip


@dataclass(frozen=True)
class PrescribedSignals:
    """Signals of such a recording."""

    position: str = "position"
    press: str = "pressure"
    force: str = "force"


def prescribed_replays(
    recording: Recording, groups: Sequence[str] = (), inertia: float = 0.0,
) -> list[Replay]:  # fmt: skip
    """Replays of the runs of the given groups (all, if none is given), in SI units.

    What noise of the position makes of the force of `inertia` [kg or kg m^2] is added to the
    force's own.
    """
    chosen = [r for r in recording.runs if not groups or r.group in groups]
    s = PrescribedSignals()
    return replayed(chosen, recording.runs, lambda run: _replay(run, recording, s, inertia))


def _replay(run: RecordedRun, recording: Recording, s: PrescribedSignals, inertia: float) -> Replay:
    time = run.time - run.time[0]
    step = row_step(time)
    even = np.linspace(0.0, time[-1], 1 + round(time[-1] / step))
    position = run.channels[s.position]
    rounds = seen_step(position) or 0.0
    noise = max(channel_noise(recording, s.position), rounds / np.sqrt(12.0))
    force = run.channels[s.force]
    own = noise_in(run, recording, s.force)
    matters = own / inertia if inertia > 0.0 else np.inf
    moved = motion_of(np.interp(even, time, position), float(even[1]), noise, matters)
    speed, bent = (np.interp(time, even, d) for d in (moved.speed, moved.acceleration))
    steady = np.interp(time, even, moved.steady(round(2.0 * AROUND / even[1]))) == 1.0
    thin = slice(None, None, max(1, round(SET / step), -(-time.size // MOST)))
    before = gaps(time)
    resolved = np.interp(time, even, moved.resolved) == 1.0
    inside = (time > AROUND) & (time < time[-1] - AROUND)
    for a, b in zip(time[before], time[before + 1], strict=True):
        inside &= (time < a - AROUND) | (time > b + AROUND)
    compared = (
        inside,
        steady | (np.abs(speed) > SLOW * np.quantile(np.abs(speed), 0.9)),
        ~_at_a_turn(time, speed, row_step(time[thin])),
        resolved,
        settled(time, run.channels.get(s.press, 0.0 * time)),
        run.compared(s.force),
    )
    why, keep = first_reason(compared)
    inertial = inertia * moved.noise
    speed = np.where(resolved, speed, _between(time, position, thin))
    inputs = {name: values[thin] for name, values in pressing(run, recording, s.press).items()}
    notes = {"position": position, "speed": speed, "acceleration": bent,
             CLEARER: np.full(time.size, own < inertial), WHY: why,
             **shifted(run, recording, {"press": s.press})}  # fmt: skip
    seen = Observation(force[thin], float(np.hypot(own, inertial)), keep[thin])
    observed = {s.force: replace(seen, step=coarse_step(force) or 0.0)}
    thinned = {name: values[thin] for name, values in notes.items()}
    return Replay(
        run.name, run.experiment, time[thin], inputs, observed, drive_is_exact=False,
        notes=thinned, **told_of_run(run, recording, vars(s).values(), thin),
    )  # fmt: skip


def first_reason(compared: Sequence[np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    """Number from 1 in `REASONS` of why a row is not compared (rows,), 0 if it is; and if it is."""
    why = np.zeros(compared[0].size)
    for number, may in enumerate(compared, 1):
        why[(why == 0.0) & ~may] = number
    return why, why == 0.0


def _at_a_turn(time: np.ndarray, speed: np.ndarray, step: float) -> np.ndarray:
    """Rows within a step [s] of a turn: what bends and yields between two of them is not known."""
    way = np.sign(speed)
    turns = time[1:][way[1:] * way[:-1] < 0.0]
    after = np.searchsorted(turns, time + step, side="right")
    return after != np.searchsorted(turns, time - step)


def _between(time: np.ndarray, position: np.ndarray, thin: slice) -> np.ndarray:
    """Speed that takes a coordinate along its recorded way, from midst to midst of rows (rows,).

    Smoothing rounds a corner off, by more than a bristle takes to bend.
    """
    at, rows = time[thin], np.zeros(time.size)
    ends = np.concatenate([at[:1], at[:-1] + 0.5 * np.diff(at), at[-1:]])
    rows[thin] = np.diff(np.interp(ends, time, position)) / np.diff(ends)
    return rows


def settled(time: np.ndarray, press: np.ndarray) -> np.ndarray:
    """Mask (rows,) without those soon after a pressure's jump, which a sensor may show late."""
    steps, size = np.abs(np.diff(press)), float(np.ptp(press))
    jumps = time[1:][steps > max(JUMP * size, 10.0 * noise_estimate(press))]
    soon = np.searchsorted(jumps, time + 2.0 * row_step(time), side="right")
    return soon == np.searchsorted(jumps, time - LONGEST)
