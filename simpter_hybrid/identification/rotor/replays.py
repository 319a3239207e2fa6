"""Replays of a recorded rotor with one clutch, driven by a speed servo or by a torque."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ..fitting.replay import Observation, Replay
from ..recordings.logged import told_of_run
from ..recordings.noise import channel_noise
from ..recordings.recording import RecordedRun, Recording
from .beginnings import LEAST, beginning
from .conditioning import Conditions, conditions, free_conditions
from .free_play import struck
from .idle_torque import idle_torque
from .signals import RotorSignals

#: Weight of a speed that is predicted from a restart: the error of the restarted state stays in
#: all residuals up to the next one.
RESTARTED_WEIGHT, FREE_WEIGHT = 0.3, 0.6
#: Relative scatter of breakaway from one to the next, where nothing is declared.
SCATTER = 0.012
#: Uncertainty of a level from a line through the last samples of the transmitted torque, in its sd.
LEVEL = 0.75


def rotor_replays(
    recording: Recording,
    groups: Sequence[str] = (),
    settles: float = LEAST,
) -> list[Replay]:
    """Replays of the runs of the given groups (all, if none is given), in SI units.

    A run in which `prescribed` applies is driven by torque: its speed is compared, restarted from
    the record; otherwise the servo is replayed and the applied torque is compared.  `settles`: how
    long after what was not recorded nothing is compared [s].
    """
    signals = RotorSignals()
    sd = noises(recording, signals)
    zero = idle_torque(recording.runs, signals, settles)
    chosen = [r for r in recording.runs if not groups or r.group in groups]
    return [
        replace(
            _replay(run, signals, sd, settles, zero), **told_of_run(run, recording, signals.all)
        )
        for run in chosen
    ]


def noises(recording: Recording, signals: RotorSignals) -> dict[str, float]:
    """Standard deviation of each measured channel [SI]."""
    names = (signals.transmitted, signals.applied, signals.speed, signals.position)
    return {name: channel_noise(recording, name) for name in names if name in recording.channels}


def _replay(
    run: RecordedRun, signals: RotorSignals, sd: dict[str, float], settles: float, zero: float
) -> Replay:
    torque = run.channels[signals.prescribed]
    by_torque = bool(np.isfinite(torque).all())
    begun = beginning(run, signals, sd, settles, zero)
    inputs = {s: np.nan_to_num(run.channels[s]) for s in signals.inputs if s in run.channels}
    transmitted = run.channels[signals.transmitted]
    notes = {s: run.channels[s] for s in (signals.position, signals.speed)}
    if not by_torque:
        observed = {
            name: Observation(run.channels[name], sd[name], begun.keep & run.compared(name))
            for name in (signals.transmitted, signals.applied)
            if name in run.channels
        }
        start = () if begun.start is None else (begun.start,)
        return Replay(run.name, run.experiment, begun.time, inputs, observed, start, notes=notes)
    engaged = bool(run.channels[signals.command].any())
    found = begun.applied_to(_conditions(run, signals, sd, engaged), run, signals, sd)
    weight = RESTARTED_WEIGHT if engaged else FREE_WEIGHT
    speed = run.channels[signals.speed]
    observed = {
        signals.transmitted: Observation(
            transmitted, sd[signals.transmitted], found.keep & run.compared(signals.transmitted)
        ),
        signals.speed: Observation(
            speed, sd[signals.speed], found.keep & run.compared(signals.speed), weight
        ),
    }
    return Replay(
        run.name,
        run.experiment,
        begun.time,
        inputs,
        observed,
        found.restarts,
        found.breakaways,
        notes=notes,
    )


def _conditions(run: RecordedRun, signals: RotorSignals, sd, engaged: bool) -> Conditions:
    position, speed = run.channels[signals.position], run.channels[signals.speed]
    if not engaged:
        return free_conditions(run.time, position, speed)
    held, noise = run.channels[signals.transmitted], sd[signals.speed]
    level, command = LEVEL * sd[signals.transmitted], run.channels[signals.command]
    moved = sd[signals.position]
    found = conditions(run.time, position, speed, held, noise, level, SCATTER, command, moved)
    after = struck(run.time, speed, held, command, (noise, sd[signals.transmitted]))
    return replace(found, keep=found.keep & ~after)
