"""What a diagnosis needs of one driven axis."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from ...loads.drive import VoltageDrive
from ...scenario import Scenario
from ..fitting.replay import Replay, measured_like
from ..recordings.gaps import left_out
from ..recordings.groups import several, shared, without_held_out
from ..recordings.recording import Recording
from ..rigs.bench import Bench, Plan
from ..rigs.effect_candidate import EffectCandidate
from ..rigs.free_start import started
from ..rigs.input_noise import InputNoise
from ..rigs.moving import check_moving
from ..rigs.pose import inertia_of
from ..rigs.scenario_predictor import ScenarioPredictor
from ..rigs.temperature import temperature_candidates
from ..rigs.zeros import zero_of_position
from .candidates import axis_candidates, with_friction_scale
from .drive import acting_late, current_candidates, drive_candidates, rippling
from .drive_force import motors_of
from .driven import Driven, how_driven, most_told
from .flexible import flexible_candidates
from .halves import halves, middle_of
from .let_go import let_go
from .motor import motor_of, pulses_untold, with_pulses
from .noise_allowed import input_noise, limits_of
from .opposed import opposed
from .plan import Planned, axis_reach, followed, laid_down, planned_axis
from .position_waves import drive_waves, end_met, waves_of
from .pressed import of_what_presses
from .recorded import of_let_alone, placeless, scaled_force, taken_as_exact, unpressed, unused
from .replays import axis_replays
from .rig import AxisRig
from .seen_drive import seen_drive
from .set_points import set_point_candidates
from .signals import AxisSignals
from .sizes import AxisSizes, pulls_back, size_of_forces, sizes_of, swung
from .speed_sensor import speed_candidates
from .starts import begun_untold
from .told_plan import motion_reach, releases, set_points, told_by_model
from .told_start import told_start
from .traces import HEAVY, AxisTracer
from .window_length import straight, window_length
from .windows import WINDOW, window_starts

Groups = Mapping[str, tuple[str, ...]]


def axis_bench(recording: Recording, declared: Scenario, groups: Groups) -> Bench:
    """Replays in windows; the library for one axis, and what may be wrong with its drive."""
    searched = without_held_out(recording, groups)
    driven, signals = how_driven(searched, declared, AxisSignals())
    supplies = [r.channels[signals.supply] for r in searched.runs if signals.supply in r.channels]
    declared = with_pulses(declared, np.concatenate(supplies or [np.zeros(0)]))
    rig = driven.rig(searched, signals)
    rig.template(declared)  # refuses a model that no record can drive
    length = window_length(searched, signals)
    parts, made = _replays(recording, signals, groups, length)
    check_moving(parts, recording, [signals.position])
    fitted, predictor = parts["fit"], ScenarioPredictor(declared, rig)
    turning = "length" not in declared.device.coordinate_dimensions
    placed = not recording.channels[signals.position].summed
    force = size_of_forces(declared, fitted)
    sizes = sizes_of(fitted, force, inertia_of(declared), turning)
    tried = _library(declared, parts, sizes, driven)
    tried += speed_candidates(searched, fitted, signals, turning, driven.alone)
    tried += flexible_candidates(fitted, sizes.inertia, turning, _heaviest(declared, predictor))
    if placed:
        tried += _of_a_place(declared, parts, driven, sizes)
    else:
        tried = placeless(predictor, fitted[0], tried)
    tried += _of_what_drives(declared, fitted, driven, force)
    if driven.told and signals.engaged not in searched.channels:
        tried += let_go(declared, fitted)
    turn = sizes.turn if placed else 0.0
    pressed = float(np.ptp(np.concatenate([run.inputs["press"] for run in fitted]))) > 0.0
    drifts = driven.alone and not placed
    tracer = AxisTracer(sizes.inertia, turn, driven.servo, drifts, pressed, motors_of(declared))

    def every(recording: Recording) -> list[Replay]:
        return [run for part in groups for run in made(recording, part)]

    allowed = input_noise(recording, driven, signals, predictor, every)
    return Bench(
        parts, predictor, lambda replays: tracer, tried, made,
        limits=limits_of(searched, driven, signals, allowed is not None, fitted),
        noise=allowed, plain_first=allowed is not None and not (driven.alone or driven.servo),
        remarks=(
            *told_start(recording), *of_let_alone(recording), *unused(recording, signals.all),
            *taken_as_exact(recording), *unpressed(predictor, fitted, recording),
            *scaled_force(recording, declared), *seen_drive(searched, declared, signals),
            *(straight(searched, signals, length) if fitted[0].restarts else ()),
            *(() if driven.alone or driven.servo else opposed(fitted, motor_of(declared)[1])),
            *begun_untold([run for runs in parts.values() for run in runs]),
            *left_out(recording, WINDOW), *(() if driven.alone else pulses_untold(declared)),
        ),
        experiments=_planned(recording, predictor, parts, allowed, signals, length),
        by_run=not shared(groups) and several(searched),
        common=_weighed_once(declared) if driven.alone else (),
        zero=zero_of_position(declared, sizes.travel, turning) if placed else None,
    )  # fmt: skip


def _weighed_once(declared: Scenario) -> tuple[str, ...]:
    """Tolerances of the inertia where nothing drives but friction.

    Only its ratio to that shows, and it is friction that is another on another day.
    """
    groups = {g["name"]: set(g["parameters"]) for g in declared.notes.get("tolerances", ())}
    own = {f"device.{name}" for name in HEAVY}
    heavy = tuple(name for name, numbers in groups.items() if numbers <= own)
    alone = not declared.loads and not pulls_back(declared)
    return heavy if len(heavy) < len(groups) and alone else ()


def _heaviest(declared: Scenario, predictor: ScenarioPredictor) -> float:
    """How many times its declared inertia a refit may give an axis."""
    own = {f"device.{name}" for name in HEAVY}
    groups = declared.notes.get("tolerances", ())
    names = {g["name"] for g in groups if own.intersection(g["parameters"])}
    return max((p.upper for p in predictor.parameters if p.name in names), default=1.0)


def _replays(recording: Recording, signals: AxisSignals, groups: Groups, length: float):
    """The parts, and how they are made of a recording, also of a changed one."""
    cut = shared(groups)
    starts = window_starts(recording, signals, groups["report"], length)

    def made(recording: Recording, part: str) -> list[Replay]:
        if not cut or part == "report":
            return axis_replays(recording, signals, groups[part], starts)
        runs = axis_replays(recording, signals, groups["fit"], starts)
        long = [run for run in runs if middle_of(run)]  # what has no two halves tells little
        return [halves(run)[part == "select"] for run in long or runs]

    return {part: made(recording, part) for part in groups}, made


def _library(
    declared: Scenario,
    parts: Mapping[str, list[Replay]],
    sizes: AxisSizes,
    driven: Driven,
) -> tuple[EffectCandidate, ...]:
    """Effects with sizes taken from the recorded motion."""
    replays, waves = parts["fit"], waves_of(parts)
    met = {side: end_met(replays, side) for side in (1.0, -1.0)}
    known = axis_candidates(sizes, waves, swung(declared, replays), met, pulls_back(declared))
    warmed = temperature_candidates(declared, replays, sizes.force, sizes.speed)
    scaled = with_friction_scale(known + warmed, declared, sizes.force)
    found = *scaled, *of_what_presses(declared, replays)
    return tuple(_or_a_sensor(c, driven, pulls_back(declared)) for c in found)


def _or_a_sensor(c: EffectCandidate, driven: Driven, pulled: bool) -> EffectCandidate:
    """Say of a constant force or a weight that it may be a sensor's zero; return all else as it is.

    No motion tells the two apart.  `pulled`: whether the model has a weight or spring of its own,
    of which a position's wrong zero makes such a force.
    """
    if c.name not in ("bias-force", "bias-drift", "imbalance"):
        return c
    where, again = c.acts_on, c.experiment
    if c.name == "bias-force" and not driven.alone:
        again = "Read the drive's zero with the load uncoupled."
        where += ", or the offset of the drive's sensor" if driven.sensed else ""
    if c.name == "bias-drift":
        again = c.experiment if driven.sensed else "The same run again, and once begun later."
        where += ", or the zero of the drive's sensor" if driven.sensed else ""
    if pulled:
        where += ", or the zero of the position"
    return replace(c, acts_on=where, experiment=again)


def _of_a_place(
    declared: Scenario, parts: Mapping[str, list[Replay]], driven: Driven, sizes: AxisSizes
) -> tuple[EffectCandidate, ...]:
    """Candidate of a drive that depends on its place, where a drive was logged."""
    if driven.alone or driven.pulled or driven.servo:
        return ()
    if isinstance(declared.loads[motor_of(declared)[0]], VoltageDrive):
        return ()  # its current is no part of what was told
    return rippling(declared, drive_waves(parts), sizes.travel)


def _of_what_drives(
    declared: Scenario, fitted: Sequence[Replay], driven: Driven, force: float
) -> tuple[EffectCandidate, ...]:
    """Candidates of what may be wrong with a drive, and with a servo's set points."""
    if driven.alone or driven.pulled:
        return ()
    most = most_told(declared, fitted, driven.servo)
    tried = drive_candidates(declared, driven.sensed, force, most)
    tried += (acting_late(declared), *current_candidates(declared, most)) if driven.sensed else ()
    return (*tried, *set_point_candidates(declared)) if driven.servo else tuple(tried)


def _planned(
    recording: Recording, predictor: ScenarioPredictor, parts: Mapping[str, list[Replay]],
    allowed: InputNoise | None, signals: AxisSignals, length: float,
) -> Plan:  # fmt: skip
    rig, fitted = predictor.rig, parts["fit"]
    every = [run for runs in parts.values() for run in runs]
    assert isinstance(rig, AxisRig)

    def future_of(values: Mapping[str, float]) -> tuple[Recording, Planned]:
        model = predictor.scenario(values)
        if not rig.alone and not rig.servo:
            reach = axis_reach(fitted, inertia_of(model), motor_of(model)[1], every)
            return planned_axis(recording, model, reach, signals)
        reach = motion_reach(fitted, inertia_of(model), every, rig.alone)
        asked = (releases if rig.alone else set_points)(recording, reach)

        def made(blank: Recording) -> list[Replay]:
            return axis_replays(blank, signals)

        given = recording, predictor, values, asked, reach.time, made
        courses = {n: channels[signals.position][:2] for n, channels in asked.items()}
        begun = {n: followed(recording, x, reach.step) for n, x in courses.items() if rig.alone}
        return told_by_model(*given, free=rig.alone), {
            n: begun.get(n, {}) | laid_down(channels) for n, channels in asked.items()
        }

    def planned(values: Mapping[str, float], replays: Sequence[Replay]) -> list[Replay]:
        future, asked = future_of(values)
        if not future.runs:  # a drive that is too weak for all of them
            return []
        starts = window_starts(future, signals, length=length)

        def anew(changed: Recording) -> list[Replay]:
            return axis_replays(changed, signals, (), starts)

        runs = [measured_like(run, replays[:1]) for run in anew(future)]
        runs = started(predictor.simulated, values, runs)
        if allowed is not None:
            weighing = replace(allowed, recording=future, made=anew, predictor=predictor)
            runs = weighing.weighed(values, runs)
        return [replace(run, laid_down=asked[run.name]) for run in runs]

    return planned
