"""A device with a tip and several clutches: recorded tip force and commands move the model.

Only positions are recorded.  Every `WINDOW` the motion is set anew from the record: position and
speed are those of the parabola fitted to the positions over `FITTED` around that instant.  An error
of such a start grows like a straight line while nothing sticks, so the line in each window's error
is taken away and what is left is compared with the full weight of its noise.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from ...applied_load import Load
from ...controller import Controller
from ...controllers.replayed_commands import ReplayedCommands, ReplayedPush
from ...device import Device
from ...loads.hand import HeldTipForce
from ...loads.replayed_force import ReplayedTipForce
from ...loads.tip_spring import TipSpring
from ...problems import InvalidInput, Problem
from ...scenario import Scenario
from ..fitting.replay import Observation, Replay
from ..recordings.channel_map import HELD
from ..recordings.course import course
from ..recordings.logged import told_of_run
from ..recordings.noise import run_noise
from ..recordings.recording import RecordedRun, Recording
from ..recordings.row_step import gaps, row_step
from ..recordings.smoothing import even_step, from_row, rate_of_change, whole
from ..rigs.beside_record import of_a_clock
from ..rigs.pose import clutch_maps
from ..rigs.rig import Rig, driven_by, handed_on
from ..rigs.scenario_runner import ScenarioRunner
from ..rigs.sensor_errors import Key, told_values
from ..rigs.start_state import later_starts, state_at_zero
from .held_force import held_means
from .sensors import read_angles, sensed, sensor_errors, sensor_keys
from .smooth_force import smooth_course

#: Length of a free prediction [s].
WINDOW = 1.0
#: Over which positions are fitted by a parabola for a window's start [s].
FITTED = 0.1
#: Degree of that parabola; stamps nearer than this part of a step are the same.
PARABOLA, SAME = 2, 1e-6
#: Fewest rows between gaps in which a window begins; time after which a command is forgotten [s].
FEWEST, FORGETS = 8, 0.5
#: Note of a replay: how its force goes on between rows along x and y, by its number in `HELD`.
FORCE_HELD = "force held"


@dataclass(frozen=True)
class TipSignals:
    """Signals of a recording of such a device; numbered from 1."""

    position: str = "position"
    command: str = "command"
    force: tuple[str, str] = ("force_x", "force_y")

    def of(self, device: Device) -> tuple[str, ...]:
        """All that a recording of such a device has to have."""
        positions = (f"{self.position}_{j + 1}" for j in range(device.n))
        commands = (f"{self.command}_{k + 1}" for k in range(device.m))
        return *self.force, *positions, *commands

    def positions(self, recording: Recording) -> list[str]:
        """``position_1`` and so on, as many as the map has."""
        return numbered(recording, self.position)

    def commands(self, recording: Recording) -> list[str]:
        """``command_1`` and so on."""
        return numbered(recording, self.command)

    def held(self, recording: Recording) -> tuple[str, str]:
        """How the force goes on between rows, along x and y."""
        x, y = (recording.channels[name].held for name in self.force)
        return x, y


def numbered(recording: Recording, name: str) -> list[str]:
    """Signals ``name_1``, ``name_2`` ... of a recording."""
    found: list[str] = []
    while f"{name}_{len(found) + 1}" in recording.channels:
        found.append(f"{name}_{len(found) + 1}")
    return found


def tip_replays(recording: Recording, groups: Sequence[str] = ()) -> list[Replay]:
    """Replays of the runs of the given groups (all, if none is given), in SI units."""
    chosen = [r for r in recording.runs if not groups or r.group in groups]
    return [_replay(run, recording, TipSignals()) for run in chosen]


def _replay(run: RecordedRun, recording: Recording, s: TipSignals) -> Replay:
    time = run.time - run.time[0]
    step = row_step(time)
    names = s.positions(recording)
    every, half = max(8, whole(WINDOW / step)), max(3, whole(0.5 * FITTED / step))
    wanted = (*s.commands(recording), *s.force)
    inputs = {name: run.channels[name] for name in wanted}
    spans, keep = _between_gaps(time, [inputs[name] for name in s.commands(recording)])
    starts = [k for a, b in spans for k in range(a, max(a + 1, b - 2 * half), every)]
    even = even_step(time)
    observed, states, speeds = {}, [], []
    for name in names:
        values, channel = run.channels[name], recording.channels[name]
        sd = run_noise(values, channel, run.time)
        observed[name] = Observation(values, sd, keep, 1.0, tuple(starts))
        clean = course(time, values, sd)
        states.append([_state_at(time, clean, k, half, sd, spans, even) for k in starts])
        speeds.append(rate_of_change(time, values, 2 * FITTED))
    rows = np.array(states)  # coordinates, windows, (position, speed)
    notes = {
        "position": np.array([run.channels[n] for n in names]),
        "speed": np.array(speeds),
        "start_at": np.array(starts),
        FORCE_HELD: np.array([HELD.index(held) for held in s.held(recording)]),
        "states": np.concatenate([rows[:, :, 0].T, rows[:, :, 1].T], axis=1),
    }
    return Replay(
        run.name, run.experiment, time, inputs, observed, drive_is_exact=False, notes=notes,
        **told_of_run(run, recording, (*names, *wanted)),
    )  # fmt: skip


def _state_at(
    time: np.ndarray, values: np.ndarray, k: int, half: int, sd: float,
    spans: Sequence[tuple[int, int]], step: float | None,
) -> tuple[float, float]:  # fmt: skip
    """Position and speed at row `k`, of rows around it on its side of every gap."""
    begin, end = next(span for span in spans if span[0] <= k < span[1])
    rows = slice(max(begin, k - half), min(end, k + half + 1))
    return state_at_zero(from_row(time, k, rows, step), values[rows], sd, PARABOLA)


def _between_gaps(
    time: np.ndarray, commands: Sequence[np.ndarray]
) -> tuple[list[tuple[int, int]], np.ndarray]:
    """Rows between gaps (first, one past the last), and what is compared (samples,).

    Not what is too short to begin in; nor what comes behind a gap in which something was commanded
    that nobody knows, until it is forgotten.
    """
    begins = [0, *(gaps(time) + 1).tolist(), time.size]
    keep, spans = np.ones(time.size, bool), list[tuple[int, int]]()
    for a, b in pairwise(begins):
        if b - a < FEWEST:
            keep[a:b] = False
            continue
        spans.append((a if spans else 0, b))  # the first window begins with the run
        if a > 0 and any(c[a] != c[a - 1] for c in commands):
            keep[a:b] &= time[a:b] > time[a] + FORGETS
    return spans or [(0, time.size)], keep


def _with_recorded_hand(loads: Sequence[Load]) -> list[Load]:
    """Loads with the recorded force in the place of a hand's, which goes by time or is told.

    Of several hands it stands for all: where the others were, nothing pushes.
    """
    made: list[Load] = []
    recorded: Load = ReplayedTipForce()
    for load in loads:
        hand = "tip_force" in load.functions() and of_a_clock(load)
        made.append(recorded if hand else load)
        recorded = TipSpring() if hand else recorded
    return made if ReplayedTipForce() in made else [*made, recorded]


@dataclass(frozen=True)
class TipRig(Rig):
    """Drives a scenario by the recorded commands of its clutches and the force on its tip.

    Parameters
    ----------
    signals : TipSignals
    holds : bool
        Whether a force is held from row to row, along x or y.
    """

    signals: TipSignals = TipSignals()
    holds: bool = False

    def template(self, declared: Scenario) -> Scenario:
        """The declared scenario driven by the record.

        Raises
        ------
        InvalidInput
            If it has no tip or no controller rate; and as `driven_by` does.
        """
        if "tip_jacobian" not in declared.device.functions() or declared.period <= 0.0:
            right = "a device with a tip, and a controller rate: that at which commands may change"
            what = "the model cannot be driven by a recorded tip force"
            raise InvalidInput([Problem(declared.name, "device", what, "the model", right)])
        stages: list[Controller] = [ReplayedCommands()]
        loads = _with_recorded_hand(declared.loads)
        if self.holds:
            stages.append(ReplayedPush())
            loads.append(HeldTipForce())
        played = ((stage, 1) for stage in stages)
        return driven_by(declared, (*played, *handed_on(declared)), loads)

    def driven(self, replay: Replay, values: Mapping[str, float]) -> Replay:
        """The run with the force and the motion that its sensors must have seen."""
        return sensed(replay, values, self.signals)

    def pack(self, replay: Replay, period: float) -> np.ndarray:
        """The record as `ReplayedCommands` and `ReplayedTipForce` read it.

        What a tick commands shows in the first row at or after it, however the map has rows held.
        """
        time = replay.time
        step = row_step(time)
        count = max(1, int(np.ceil(time[-1] / period)))
        at = np.searchsorted(time, np.arange(count) * period - SAME * step)
        rows = np.minimum(at, time.size - 1)
        columns = [command[rows] for command in self._commands(replay)]
        knots = np.arange(count + 2) * period
        curves, held = [], replay.notes[FORCE_HELD] if self.holds else (0, 0)
        for name, how in zip(self.signals.force, held, strict=True):
            force, nothing = replay.inputs[name], 0.0 * replay.inputs[name]
            smooth = HELD[how] == "sampled"
            if self.holds:
                pushes = 0.0 * rows if smooth else held_means(knots[:-1], time, force, HELD[how])
                columns.append(pushes)
            through = smooth_course(time, force) if smooth else (nothing, nothing)
            curves += [np.interp(knots, time, values) for values in through]
        head = [count, len(columns), knots.size, period]
        rows_and_knots = np.column_stack(columns).ravel(), np.column_stack(curves).ravel()
        return np.concatenate([head, *rows_and_knots])

    def start(self, replay: Replay) -> np.ndarray:
        """q and qd at the first sample."""
        return replay.notes["states"][0]

    def excited(self, replay: Replay) -> tuple[float, ...]:
        """The first row's commands, as if they had acted for long: a run may be cut anywhere."""
        return tuple(float(command[0]) for command in self._commands(replay))

    def restarts(self, replay: Replay) -> list[tuple[float, tuple[float, ...]]]:
        """Instants just before the samples at which the motion is set from the record."""
        return later_starts(replay)

    def channels(
        self, runner: ScenarioRunner, replay: Replay, parameters: np.ndarray, data, rows: np.ndarray
    ) -> dict[str, np.ndarray]:
        """Positions, and what tracing asks for, numbered like them."""
        z = runner.program.z
        n, m, ny = z["n"], z["m"], z["ny"]
        torque = rows[:, ny + n : ny + n + m]
        taken = np.einsum("ki,kij->kj", torque, clutch_maps(runner.scenario, rows[:, :n]))
        found = {"breakaway_torque": np.zeros(len(rows))}
        for j in range(n):
            found[f"{self.signals.position}_{j + 1}"] = rows[:, j]
            found[f"speed_{j + 1}"] = rows[:, n + j]
            found[f"acceleration_{j + 1}"] = rows[:, ny + j]
            found[f"friction_{j + 1}"] = taken[:, j]
        for i in range(m):
            found[f"excitation_{i + 1}"] = rows[:, 2 * n + i]
            found[f"torque_{i + 1}"] = -torque[:, i]
        return found

    def read(
        self, replay: Replay, values: Mapping[str, float], channels: dict[str, np.ndarray]
    ) -> None:
        """The angles through sensors with gains and offsets."""
        read_angles(replay, values, channels, self.signals.position)

    def declared_sensor_errors(self, declared: Scenario) -> dict[str, float]:
        """The declared sensors of angles and tip force."""
        return told_values(declared, sensor_keys(declared.device))

    def errors(self, values: Mapping[str, float], device: Device) -> dict[Key, float]:
        """Fitted errors of the sensors of angles and tip force, as ``[readings]`` say them."""
        return sensor_errors(values, device)

    def _commands(self, replay: Replay) -> list[np.ndarray]:
        inputs, own = replay.inputs, f"{self.signals.command}_"
        return [inputs[name] for name in inputs if name.startswith(own)]
