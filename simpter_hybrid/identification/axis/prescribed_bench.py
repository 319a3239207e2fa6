"""What a diagnosis needs of a coordinate that is moved from outside."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import astuple, replace
from functools import partial

import numpy as np

from ...problems import Problems
from ...scenario import Scenario
from ..fitting.replay import Replay
from ..fitting.residual import rms
from ..recordings.groups import several
from ..recordings.noise import channel_noise
from ..recordings.recording import Recording
from ..rigs.bench import Bench, Plan
from ..rigs.effect_candidate import EffectCandidate
from ..rigs.pose import inertia_of
from ..rigs.scenario_predictor import ScenarioPredictor
from ..rigs.temperature import temperature_candidates
from ..tracing.limits import SINGLE_AXIS
from ..tracing.rivals import LEAST_GAIN
from ..tracing.traced import Tracer
from .bench import Groups
from .candidates import axis_candidates, with_friction_scale
from .drive import drive_candidates
from .motion_noise import motion_noise
from .plan import followed, laid_down
from .position_waves import Balance, end_met, waves_of
from .prescribed_replays import JUMPS, REASONS, WHY, PrescribedSignals, prescribed_replays
from .prescribed_rig import PrescribedRig, PrescribedTracer
from .pressed import of_what_presses
from .recorded import placeless, unpressed, unused
from .signals import AxisSignals
from .sizes import pulls_back, sizes_of
from .told_plan import motion_reach, motions, told_by_model

#: Delays or lags at which fits of a late sensor begin [s].  Around a turn single rows change sides,
#: one at a time: between such delays the error has no slope to follow.
LATE = ((0.0,), (0.005,), (0.015,), (0.03,))
#: Gain asked of an effect beyond `LEAST_GAIN` where all noise is what a sensor rounds away: that
#: comes again with a motion, and a null gained 1.6 % by following it (more in one experiment).
ROUNDED = 0.05
#: Fewest rows that are compared, of the runs that fit, that select and that are reported.
LEAST_ROWS = 50


def prescribed_bench(recording: Recording, declared: Scenario, groups: Groups) -> Bench:
    """The library for one axis, and what may be wrong with the sensor of its force."""
    inertia, predictor = inertia_of(declared), ScenarioPredictor(declared, PrescribedRig())

    def made(recording: Recording, part: str) -> list[Replay]:
        replays = prescribed_replays(recording, groups[part], inertia=inertia)
        return pressed_anew(predictor, replays, recording)

    def tracer(replays: Sequence[Replay]) -> Tracer:
        placed = not recording.channels[signals.position].summed
        return PrescribedTracer(turn=sizes.turn if placed else 0.0)

    parts = {part: made(recording, part) for part in groups}
    fitted, name = parts["fit"], PrescribedSignals().force
    signals = AxisSignals()
    check_compared(parts, recording)

    force = max(float(np.std(r.observed[name].values)) for r in fitted)
    turning = "length" not in declared.device.coordinate_dimensions
    balance = partial(_balance, inertia)
    waves = waves_of(parts, balance)
    met = {side: end_met(fitted, side, balance) for side in (1.0, -1.0)}
    sizes = sizes_of(fitted, force, inertia, turning)
    effects = axis_candidates(sizes, waves, met=met, pulled=pulls_back(declared))
    tried = with_friction_scale(tuple(map(_or_the_sensor, effects)), declared, force)
    least = by_smoothing(fitted, recording)
    late = (
        replace(c, least=least, starts=LATE) if c.family == "drive timing" else c
        for c in drive_candidates(declared, sensed=True)
    )
    warmed = temperature_candidates(declared, fitted, force, sizes.speed)
    tried = (*tried, *of_what_presses(declared, fitted), *warmed, *late)
    if (share := rounded(fitted)) > 0.0:
        asked = LEAST_GAIN + ROUNDED * share
        tried = tuple(replace(c, least=max(c.least, asked)) for c in tried)
    known = astuple(PrescribedSignals())
    if recording.channels[signals.position].summed:
        known = (*known, signals.speed)
        tried = placeless(predictor, fitted[0], tried, name)
    remarks = (*unused(recording, known), *unpressed(predictor, fitted, recording))
    return Bench(
        parts, predictor, tracer, tried, made, limits=SINGLE_AXIS, remarks=remarks,
        experiments=_planned(recording, predictor, parts, inertia), by_run=several(recording),
        noise=motion_noise(recording, predictor, inertia),
    )  # fmt: skip


def _balance(inertia: float, replay: Replay) -> Balance:
    """The tester gives what inertia takes, less what drives: the balance of a driven axis."""
    press, way = replay.inputs["press"], np.sign(replay.notes["speed"])
    known = np.column_stack([replay.notes["acceleration"], press, press * way])
    seen = replay.observed[PrescribedSignals().force]
    return Balance(-seen.values / inertia, known, seen.keep)


def _or_the_sensor(c: EffectCandidate) -> EffectCandidate:
    """Say of a constant force, or one that grows with time, that it may be the sensor's zero."""
    if c.name not in ("bias-force", "bias-drift"):
        return c
    again = "Read the force sensor with nothing touching it, before a run and after it."
    return replace(c, acts_on=f"{c.acts_on}, or the zero of the force sensor", experiment=again)


def _planned(
    recording: Recording, predictor: ScenarioPredictor, parts: Mapping[str, list[Replay]],
    inertia: float,
) -> Plan:  # fmt: skip
    name = PrescribedSignals().force

    def made(future: Recording) -> list[Replay]:
        return prescribed_replays(future, inertia=inertia)

    def told(channels: Mapping[str, np.ndarray], step: float) -> dict[str, np.ndarray]:
        course = followed(recording, channels[AxisSignals().position], step)
        return course | laid_down(channels)

    def planned(values: Mapping[str, float], replays: Sequence[Replay]) -> list[Replay]:
        every = [run for runs in parts.values() for run in runs]
        reach = motion_reach(parts["fit"], inertia, every)
        asked = motions(recording, reach)
        future = told_by_model(recording, predictor, values, asked, reach.time, made)
        runs = pressed_anew(predictor, made(future), future)
        # A motion of its own has noise of its own, in the deviations that the others are judged in.
        judged, plain = (r[0].observed[name].sd for r in (replays, parts["select"]))
        runs = [replace(run, laid_down=told(asked[run.name], reach.step)) for run in runs]
        return [_times(run, name, judged / plain) for run in runs]

    return planned


def _times(run: Replay, name: str, ratio: float) -> Replay:
    seen = run.observed[name]
    return replace(run, observed={**run.observed, name: replace(seen, sd=ratio * seen.sd)})


def rounded(replays: Sequence[Replay]) -> float:
    """Part of the error (mean square) that a sensor which rounds coarsely makes, as a median."""
    seen = [r.observed[PrescribedSignals().force] for r in replays]
    return float(np.median([min(1.0, (o.step / o.sd) ** 2 / 12.0) for o in seen]))


def check_compared(parts: Mapping[str, Sequence[Replay]], recording: Recording) -> None:
    """Check that enough rows of every part may be compared.

    Raises
    ------
    InvalidInput
        With one problem for each part that has fewer than `LEAST_ROWS`.
    """
    problems = Problems(recording.source)
    for part, replays in parts.items():
        keeps = [seen.keep for r in replays for seen in r.observed.values()]
        kept, every = sum(int(k.sum()) for k in keeps), sum(k.size for k in keeps)
        if kept < LEAST_ROWS:
            whys = Counter(np.concatenate([r.notes[WHY] for r in replays]).astype(int).tolist())
            told = [(REASONS[number - 1], n) for number, n in whys.most_common() if number]
            left = ", ".join(f"{n} {reason}" for reason, n in told)
            right = f"{LEAST_ROWS} rows: longer or slower runs, rows closer together"
            if JUMPS in dict(told):
                right += "; rows of spikes left out (blank cells, and `missing` in the map)"
            what = f"too little of the runs that {part} can be compared"
            what += f"; left out are {left}" if told else ""
            problems.add((), what, f"{kept} of {every} rows", right)
    problems.raise_if_any()


def by_smoothing(replays: Sequence[Replay], recording: Recording) -> float:
    """Gain that must be asked of a late or lagging sensor, since smoothing alone gains some.

    Half a row late, a force is the mean of two rows, and its noise is halved in mean squares (a
    null gained 4 % with 0.3 ms so).  The shift is made to the clearer of what is measured and what
    is predicted.  And rows are left out that, late, would show rows which are not compared.
    """
    name = PrescribedSignals().force
    own = channel_noise(recording, name)
    every = max(own, float(np.median([r.observed[name].sd for r in replays])))
    part = (own / every) ** 2
    untold = float(np.mean([_untold(r, r.observed[name].keep) for r in replays]))
    left = (1.0 - 0.5 * min(part, 1.0 - part)) * (1.0 - untold)
    return LEAST_GAIN + 1.0 - float(np.sqrt(left))


def _untold(replay: Replay, keep: np.ndarray) -> float:
    """Part of the compared rows that, delayed by the largest trial delay, read excluded rows."""
    before = np.interp(replay.time - LATE[-1][0], replay.time, keep.astype(float))
    return float(np.mean(before[keep] < 1.0)) if keep.any() else 0.0


def pressed_anew(
    predictor: ScenarioPredictor, replays: Sequence[Replay], recording: Recording
) -> list[Replay]:
    """Replays whose force carries also what noise of the pressure makes of it.

    By the declared model: a piston of 5 cm^2 makes a tenth of a newton of 200 Pa.
    """
    name, press = PrescribedSignals().force, PrescribedSignals().press
    if press not in recording.channels:
        return list(replays)
    noise = channel_noise(recording, press)
    values = {p.name: p.value for p in predictor.parameters}
    noisy = [{**r.inputs, "press": r.inputs["press"] + noise} for r in replays]
    more = [replace(r, inputs=i) for r, i in zip(replays, noisy, strict=True)]
    first, second = (predictor.predict(values, runs)[name] for runs in (replays, more))
    found = []
    for replay, one, other in zip(replays, first, second, strict=True):
        seen = replay.observed[name]
        moved = float(np.nan_to_num(rms((other - one)[seen.keep])))
        sd = float(np.hypot(seen.sd, moved))
        found.append(replace(replay, observed={name: replace(seen, sd=sd)}))
    return found
