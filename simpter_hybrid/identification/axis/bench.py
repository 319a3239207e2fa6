"""What a diagnosis needs of one driven axis."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from ...controllers.replayed_reference import ReplayedReference
from ...effects.spring_force import SpringForce
from ...scenario import Scenario
from ..fitting.replay import Replay, measured_like
from ..recordings.gaps import left_out
from ..recordings.groups import shared, without_held_out
from ..recordings.noise import coarse_step
from ..recordings.recording import Recording
from ..recordings.smoothing import FITTED, derivative, speed_width
from ..rigs.bench import Bench, Plan
from ..rigs.effect_candidate import EffectCandidate
from ..rigs.input_noise import InputNoise
from ..rigs.scenario_predictor import ScenarioPredictor
from ..rigs.temperature import temperature_candidates
from ..tracing.limits import COARSE_AXIS, ROUNDED_AXIS, SIMULATED_AXIS, SINGLE_AXIS
from ..tracing.traced import Tracer
from .candidates import axis_candidates, with_friction_scale
from .drive import drive_candidates, motor_of
from .halts import sticks_and_slips
from .halves import halves, middle_of
from .plan import axis_reach, planned_axis
from .position_waves import SLOW, waves_of
from .pressed import lag_off, pressed_candidates
from .recorded import held_before, placeless, taken_as_exact, unpressed, unused
from .replays import WINDOW, AxisSignals, axis_replays, window_starts
from .rig import AxisRig, follower, pulling
from .set_points import set_point_candidates
from .told_plan import motion_reach, releases, set_points, told_by_model
from .traces import AxisTracer

Groups = Mapping[str, tuple[str, ...]]
#: Times that the noise of inputs is added once more.  What white noise of a current does to half a
#: second of positions has a dozen shapes above an encoder's noise: by 12 draws of it a null was
#: left at 1.57 times its floor, by 24 at 1.05, by these at 0.96.
DRAWS = 48
#: The limit of a servo that has none [V].
UNLIMITED = 1e300
#: What is let alone, or behind a servo, has the noise of its start, or of a loop, alone.
DRAWS_WHOLE = 12


def axis_bench(recording: Recording, declared: Scenario, groups: Groups) -> Bench:
    """Replays in windows; the library for one axis, and what may be wrong with its drive."""
    signals = AxisSignals()
    sensed = bool(signals.sensed & recording.channels.keys())
    alone = not recording.map.driven
    servo = not alone and not set(signals.drive) & recording.channels.keys()
    pulled = servo and bool(pulling(declared))
    searched = without_held_out(recording, groups)
    slipping = (searched, signals.position, signals.reference)
    anew = pulled or (servo and forgets(declared) and sticks_and_slips(*slipping))
    signals = replace(signals, anew=anew)
    nothing = alone and signals.press not in recording.channels
    played = row_step(recording) if nothing or pulled else 0.0
    rig = AxisRig(sensed=sensed, alone=alone, servo=servo, played=played)
    rig.template(declared)  # refuses a model that no record can drive
    parts, made = _replays(recording, signals, groups)
    turning = "length" not in declared.device.coordinate_dimensions
    force = size_of_forces(declared, parts["fit"])
    library = _library(declared, parts, turning, force) + pressed_candidates(parts["fit"])
    library += lag_off(declared, parts["fit"])
    if not alone:
        zero = "Read the drive's zero with the load uncoupled."
        # Of a sensor no motion tells one from the other.
        where = "load, or the offset of the drive's sensor" if sensed else "load"
        library = tuple(
            replace(c, acts_on=where, experiment=zero) if c.name == "bias-force" else c
            for c in library
        )
    predictor = ScenarioPredictor(declared, rig)
    if recording.channels[signals.position].summed:
        library = placeless(predictor, parts["fit"][0], library)
    if not (alone or pulled):
        most = most_told(declared, parts["fit"], servo)
        library = (*library, *drive_candidates(declared, sensed, force, most))
    if servo and not pulled:
        library = (*library, *set_point_candidates(declared))
    inertia = inertia_of(declared)
    low, high = ends_of(parts["fit"])
    turns = turning and high - low > 2 * np.pi  # else the angle is one that does not come again

    def tracer(replays: Sequence[Replay]) -> Tracer:
        placed = not recording.channels[signals.position].summed
        return AxisTracer(inertia, (2 * np.pi if turns else np.inf) if placed else 0.0, servo)

    allowed, with_speed = None, signals.speed in recording.channels
    if sensed or alone or not with_speed:

        def every(recording: Recording) -> list[Replay]:
            return [run for part in groups for run in made(recording, part)]

        noise = {name: seen.sd for name, seen in parts["fit"][0].observed.items()}
        told, seen = frozenset(signals.told), signals.sensed | {signals.reference}
        draws = DRAWS_WHOLE if alone or servo else DRAWS
        allowed = InputNoise(predictor, recording, every, noise, told, seen, draws)
    limits = SINGLE_AXIS
    if allowed is not None:
        step = float(np.median(np.diff(parts["fit"][0].time)))
        # Over a whole run a start that is a little wrong is one of its curves.
        coarse = not (with_speed or alone) and speed_width(step) > FITTED
        limits = COARSE_AXIS if coarse else SIMULATED_AXIS
        limits = (ROUNDED_AXIS if rounded(searched, signals) else limits)._replace(drive=sensed)
    limits = limits._replace(told=not (sensed or alone or servo))
    plan = _planned(recording, predictor, parts["fit"], allowed, signals)
    return Bench(
        parts, predictor, tracer, library, made, limits=limits, noise=allowed,
        plain_first=allowed is not None and not (alone or servo),
        remarks=(
            *held_before(recording), *unused(recording, signals.all), *taken_as_exact(recording),
            *unpressed(predictor, parts["fit"][0], recording),
            *left_out(recording, WINDOW),
        ),
        experiments=plan,
        by_run=not shared(groups),
    )  # fmt: skip


def most_told(declared: Scenario, replays: Sequence[Replay], servo: bool) -> float:
    """The largest that a driver was told, or may be by its servo [V]; 0 if nobody knows."""
    if not servo:
        return max(float(np.abs(r.inputs["drive"]).max()) for r in replays)
    limit = getattr(follower(declared), "limit", UNLIMITED)
    return limit if limit < UNLIMITED else 0.0


def forgets(declared: Scenario) -> bool:
    """Whether the servo of a model knows nothing of what was."""
    loop = follower(declared)
    return isinstance(loop, ReplayedReference) and not (loop.integral_gain or loop.differenced)


def rounded(recording: Recording, signals: AxisSignals) -> bool:
    """Whether the sensor of the drive rounds so coarsely that noise does not carry it across."""
    names = signals.sensed & recording.channels.keys()
    known = [n for n in names if recording.channels[n].noise is None]
    return any(coarse_step(run.channels[n]) for n in known for run in recording.runs)


def row_step(recording: Recording) -> float:
    """The usual time between rows [s]."""
    return float(np.median(np.concatenate([np.diff(run.time) for run in recording.runs])))


def _replays(recording: Recording, signals: AxisSignals, groups: Groups):
    """The parts, and how they are made of a recording, also of a changed one."""
    cut = shared(groups)
    starts = window_starts(recording, signals, groups["report"])

    def made(recording: Recording, part: str) -> list[Replay]:
        if not cut or part == "report":
            return axis_replays(recording, signals, groups[part], starts)
        runs = axis_replays(recording, signals, groups["fit"], starts)
        long = [run for run in runs if middle_of(run)]  # what has no two halves tells little
        return [halves(run)[part == "select"] for run in long or runs]

    return {part: made(recording, part) for part in groups}, made


def _library(
    declared: Scenario, parts: Mapping[str, list[Replay]], turning: bool, force: float
) -> tuple[EffectCandidate, ...]:
    """Effects with sizes taken from the recorded motion."""
    replays, inertia = parts["fit"], inertia_of(declared)
    speed = max(float(np.quantile(np.abs(r.notes["speed"]), 0.99)) for r in replays)
    travel = max(float(np.ptp(r.notes["position"])) for r in replays)
    lasts = max(float(r.time[-1]) for r in replays)
    ends, waves = ends_of(replays), waves_of(parts)
    pulled = swung(declared, replays)
    known = axis_candidates(speed, force, travel, lasts, inertia, turning, *ends, waves, pulled)
    warmed = temperature_candidates(declared, replays, force, speed)
    return with_friction_scale(known + warmed, declared)


def size_of_forces(declared: Scenario, replays: Sequence[Replay]) -> float:
    """That of inertia in the record, or twice the friction, if that is more [N or N m]."""
    shaken = max(
        float(np.quantile(np.abs(np.gradient(r.notes["speed"], r.time)), 0.9)) for r in replays
    )
    level = declared.clutches[0].torque.parameters().get("coulomb", 0.0)
    return max(inertia_of(declared) * shaken, 2.0 * level)


def swung(declared: Scenario, replays: Sequence[Replay]) -> tuple[tuple[float, float], ...]:
    """Stiffness and rest of the spring by which runs let alone swing, if none is declared.

    A model without it rests where it is let go, and from there no small stiffness moves it.
    """
    names = {type(effect) for effect in declared.effects}
    pulled = declared.device.parameters().get("weight", 0.0) or SpringForce in names
    if pulled or any(r.inputs["drive"].any() for r in replays):
        return ()
    rows = []
    for replay in replays:
        step, speed = float(np.median(np.diff(replay.time))), replay.notes["speed"]
        bent = derivative(speed, step, speed_width(step))
        moving = np.abs(speed) > SLOW * float(np.quantile(np.abs(speed), 0.9))
        told = [replay.notes["position"], np.ones(speed.size), np.sign(speed), bent]
        rows.append(np.column_stack(told)[moving])
    known = np.concatenate(rows)
    slope, level, _ = np.linalg.lstsq(known[:, :3], known[:, 3], rcond=None)[0]
    return ((-inertia_of(declared) * slope, -level / slope),) if slope < 0.0 else ()


def inertia_of(declared: Scenario) -> float:
    """The inertia that an axis declares first [kg or kg m^2]."""
    return next(iter(declared.device.parameters().values()))


def ends_of(replays: Sequence[Replay]) -> tuple[float, float]:
    """Ends of the coordinate in the record."""
    reached = [(r.notes["position"].min(), r.notes["position"].max()) for r in replays]
    return float(min(a for a, _ in reached)), float(max(b for _, b in reached))


def _planned(
    recording: Recording, predictor: ScenarioPredictor, fitted: Sequence[Replay],
    allowed: InputNoise | None, signals: AxisSignals,
) -> Plan:  # fmt: skip
    rig = predictor.rig
    assert isinstance(rig, AxisRig)

    def future_of(values: Mapping[str, float]) -> Recording:
        model = predictor.scenario(values)
        if not rig.alone and not rig.servo:
            reach = axis_reach(fitted, inertia_of(model), motor_of(model)[1])
            return planned_axis(recording, model, reach, signals)
        reach = motion_reach(fitted, inertia_of(model))
        asked = (releases if rig.alone else set_points)(recording, reach)

        def made(blank: Recording) -> list[Replay]:
            return axis_replays(blank, signals)

        given = recording, predictor, values, asked, reach.time, made
        return told_by_model(*given, free=rig.alone)

    def planned(values: Mapping[str, float], replays: Sequence[Replay]) -> list[Replay]:
        future = future_of(values)
        starts = window_starts(future, signals)

        def anew(changed: Recording) -> list[Replay]:
            return axis_replays(changed, signals, (), starts)

        runs = anew(future)
        if allowed is not None:
            weighing = replace(allowed, recording=future, made=anew, predictor=predictor)
            runs = weighing.weighed(values, runs)
        return [measured_like(run, replays[0]) for run in runs]

    return planned
