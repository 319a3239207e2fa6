"""The recording of one axis as people make them: a speed alone, a clutch's command, more besides.

Of a speed alone the position is summed up from each run's start.  Where that was is not known, so
nothing that depends on the place can be: such effects are not tried, and a model that depends on
the place is refused.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
from scipy.integrate import cumulative_trapezoid

from ...effects.by_temperature import FrictionByTemperature
from ...loads.drive import ForceDrive
from ...problems import InvalidInput, Problem
from ...reading.reader import one_of
from ...scenario import Scenario
from ...units import is_unit
from ..fitting.replay import Replay
from ..recordings.channel_map import ChannelMap
from ..recordings.checks import Finding
from ..recordings.driven_on import DRIVEN_ON, driven_on
from ..recordings.logged import ASKED_OF
from ..recordings.noise import noise_estimate
from ..recordings.recording import Recording
from ..recordings.releases import HELD, let_go
from ..recordings.rest_level import LEVEL, rest_remarks
from ..rigs.effect_candidate import EffectCandidate
from ..rigs.scenario_predictor import ScenarioPredictor
from .prescribed_replays import PrescribedSignals
from .signals import AxisSignals

#: Name that other rigs have for what presses the friction: a clutch's command.
COMMAND = "command"
#: Name that people give to the force of an axis that turns.
TORQUE = "torque"
#: Ending of a residual's coordinate that is a position: ``balance:position``.
PLACE = ":position"
#: To see whether the place matters a run is moved by so much [m or rad]; it does not if the speed
#: then changes by less than this part.
ELSEWHERE, SAME = 1.0, 1e-6
#: A constant this near one may be that of a refitted sensor.
REFITTED = 0.2
#: A supply's noise of this part of it is worth stating in the map.
NOISY = 5e-4


def as_axis(recording: Recording) -> Recording:
    """The recording of an axis with a position, and with a command as what presses.

    One that is let alone begins where it is let go.
    """
    s, channels = AxisSignals(), dict(recording.channels)
    if not {s.position, s.speed} & channels.keys():
        return recording
    names = _renamed(channels, s)
    for name, known in names.items():
        channels[known] = replace(channels.pop(name), signal=known)
    runs = [run.renamed(names) for run in recording.runs]
    if s.position not in channels:
        channels[s.position] = replace(
            channels[s.speed], signal=s.position, column=f"{channels[s.speed].column}, summed up",
            unit="", noise=None, step=None, limits=None, filter=None, left=None, summed=True,
        )  # fmt: skip
        runs = [
            replace(r, channels={**r.channels, s.position: _summed(r.time, r.channels[s.speed])})
            if s.speed in r.channels
            else r
            for r in runs
        ]
    findings = recording.findings
    if not recording.map.driven and s.press not in channels:
        told = s.speed if s.speed in channels else s.position
        runs, held = let_go(runs, channels, told)
        begun = driven_on(runs, channels[told], s.speed)
        findings = (*findings, *held, *begun, *rest_remarks(runs, channels[told], s.speed))
    named = replace(recording.map, channels=channels)
    return replace(recording, map=named, runs=tuple(runs), findings=findings)


def _renamed(channels: Mapping[str, ChannelMap], s: AxisSignals) -> dict[str, str]:
    """Names by which people call what presses, what a tester measures, what is seen of a drive."""
    found = s.beside(channels)
    if COMMAND in channels and s.press not in channels:
        found[COMMAND] = s.press
    place = channels.get(s.position, channels.get(s.speed))
    moved = place is not None and place.role == "input"
    measured = TORQUE in channels and channels[TORQUE].role == "measured"
    if moved and measured and PrescribedSignals().force not in channels:
        found[TORQUE] = PrescribedSignals().force
    return found


def _summed(time: np.ndarray, speed: np.ndarray) -> np.ndarray:
    return cumulative_trapezoid(speed, time, initial=0.0)


def of_let_alone(recording: Recording) -> tuple[Finding, ...]:
    """Remarks on how an axis let alone begins (rows left out or not), and where it rests."""
    return tuple(f for f in recording.findings if f.what in (HELD, DRIVEN_ON, LEVEL))


def unused(recording: Recording, known: Sequence[str]) -> tuple[Finding, ...]:
    """Remarks on channels that no rig of this kind uses."""
    return tuple(
        Finding("all runs", _unused(signal, channel), channel.column, _used(signal, known), -1, 0.0)
        for signal, channel in recording.channels.items()
        if signal not in known and not channel.adds_to
    )


def _used(signal: str, known: Sequence[str]) -> str:
    s = AxisSignals()
    if signal == s.speed and s.position in known:  # a tester's motion is told by one of both
        return "the map without the position, if the speed is the surer of the two"
    if signal == FrictionByTemperature().follows():
        return "nothing else, if it is the temperature of what rubs"
    return f"{one_of(known, signal)}, or no such channel in the map"


def _unused(signal: str, channel: ChannelMap) -> str:
    if signal == FrictionByTemperature().follows():
        return f"only effects that follow it read the channel {signal}"
    asked = "what is left is asked whether it depends on it"
    if channel.role == "constant":
        asked = "what differs from run to run is asked whether it goes with it, of "
        asked += f"{ASKED_OF} runs and more that fit and select"
    return f"nothing uses the channel {signal}, but {asked}"


def unpressed(
    predictor: ScenarioPredictor, fitted: Sequence[Replay], recording: Recording
) -> tuple[Finding, ...]:
    """A remark where what presses was logged, and the declared model does not ask for it.

    Judged by the run that is pressed most: one in which nothing presses is the same without it.
    """
    channel = recording.channels.get(AxisSignals().press)
    if channel is None:
        return ()
    replay = max(fitted, key=lambda run: float(np.abs(run.inputs["press"]).max()))
    values = {p.name: p.value for p in predictor.parameters}
    idle = replace(replay, inputs={**replay.inputs, "press": 0.0 * replay.inputs["press"]})
    here, there = (predictor.predict(values, [r]) for r in (replay, idle))
    if not all(np.array_equal(here[c][0], there[c][0], equal_nan=True) for c in replay.observed):
        return ()
    what = f"the declared model does not depend on {channel.column}, which may press"
    right = "friction with a `normal`, if it is pressed by that"
    return (Finding("all runs", what, channel.column, right, -1, 0.0),)


def scaled_force(recording: Recording, declared: Scenario) -> tuple[Finding, ...]:
    """A remark where a force is in a unit of force, and acts times another number than one."""
    forces = [load for load in declared.loads if type(load) is ForceDrive]
    name = next((d for d in AxisSignals().drive if d in recording.channels), None)
    if not forces or name is None or abs(forces[0].constant - 1.0) <= REFITTED:
        return ()
    channel = recording.channels[name]
    if not any(is_unit(channel.unit, kind) for kind in ("force", "torque")):
        return ()
    what = f"the model's force-drive takes channel {name} times {forces[0].constant:g}"
    right = "a constant of 1 for each volt, unless a gear or a lever lies between"
    return (Finding.of_all(what, channel.unit, right),)


def taken_as_exact(recording: Recording) -> tuple[Finding, ...]:
    """Remarks on a drive in the unit of what a sensor sees, and a supply, without stated noise."""
    return (*_drive_as_exact(recording), *_supply_as_exact(recording))


def _supply_as_exact(recording: Recording) -> tuple[Finding, ...]:
    name = AxisSignals().supply
    channel = recording.channels.get(name)
    if channel is None or channel.noise is not None:
        return ()
    runs = [run.channels[name] for run in recording.runs if name in run.channels]
    noise = max((noise_estimate(values) for values in runs if values.size > 2), default=0.0)
    if not noise > NOISY * max(float(np.abs(values).max()) for values in runs):
        return ()
    what = "the supply differs from row to row as by noise, and is taken as exact"
    right = f"its noise in the map, here about {channel.written_change(noise).lstrip('-')}"
    return (Finding("all runs", what, channel.column, right, -1, 0.0),)


def _drive_as_exact(recording: Recording) -> tuple[Finding, ...]:
    channel = recording.channels.get("drive")
    if channel is None or channel.noise is not None:
        return ()
    seen = next((k for k in ("current", "force", "torque") if is_unit(channel.unit, k)), None)
    if seen is None:
        return ()
    what = f"the drive is in {channel.unit} and taken as exact, as what a driver was told"
    right = f"the signal called {seen} if a sensor saw it, or its noise in the map"
    return (Finding("all runs", what, channel.column, right, -1, 0.0),)


def _elsewhere(replay: Replay) -> Replay:
    """A replay of the same motion at another place: a prescribed one, or one that starts there."""
    name = AxisSignals().position
    if "start" in replay.notes:
        notes = {"start": replay.notes["start"] + np.array([ELSEWHERE, 0.0])}
    else:
        notes = {name: replay.notes[name] + ELSEWHERE}
    restarts = tuple(replace(r, position=r.position + ELSEWHERE) for r in replay.restarts)
    return replace(replay, notes={**replay.notes, **notes}, restarts=restarts)


def placeless(
    predictor: ScenarioPredictor,
    replay: Replay,
    tried: Sequence[EffectCandidate],
    channel: str = AxisSignals().speed,
) -> tuple[EffectCandidate, ...]:
    """Candidates that show elsewhere than in the position, which is taken from their coordinates.

    `channel` is what is compared.

    Raises
    ------
    InvalidInput
        If what the declared model predicts depends on the position.
    """
    values = {p.name: p.value for p in predictor.parameters}
    here, there = (predictor.predict(values, [r])[channel][0] for r in (replay, _elsewhere(replay)))
    if float(np.abs(here - there).max()) > SAME * float(np.abs(here).max()):
        what = "the model depends on the position, which was not logged"
        right = (
            "a channel called position beside it (of a gyroscope its sum from a known place), or a "
            "model without weight or springs"
        )
        raise InvalidInput([Problem(predictor.declared.name, "device", what, "speed alone", right)])
    elsewhere = ((c, tuple(w for w in c.coordinates if not w.endswith(PLACE))) for c in tried)
    return tuple(replace(c, coordinates=rest) for c, rest in elsewhere if rest or not c.coordinates)
