"""Planned experiments of a device with a tip as the recordings that they would give.

The hand's force is whatever its arm and the device make of the path: it is simulated with the
model and then logged with the positions, in the noise of the sensors, as a recorded run is.  From
there on a planned run is treated like a recorded one: started anew from its positions, driven by
its logged force.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ...loads.following_hand import FollowingHand, gives_way
from ...loads.replayed_force import ReplayedTipForce
from ...measuring.over_poses import over_poses
from ...scenario import Scenario
from ..fitting.replay import Replay
from ..recordings.noise import channel_noise
from ..recordings.recording import RecordedRun, Recording
from ..recordings.row_step import row_step
from ..rigs.pose import evaluated
from ..rigs.scenario_runner import GivenRun, ScenarioRunner
from .experiments import TipPlan, TipReach, tip_experiments
from .rig import TipRig, TipSignals

#: The arm gives way by this part of the tip's way under the largest force, and is damped by this
#: part of what would be critical: stiff enough to follow, soft enough to be an arm.
GIVES, DAMPED = 0.15, 0.7
#: A rig whose "force" is the path.
PATH = TipRig(TipSignals(force=("path_x", "path_y")))


def tip_reach(declared: Scenario, replays: Sequence[Replay]) -> TipReach:
    """How far recorded runs of a device with a tip went, from which new ones are planned."""
    n, m = declared.device.n, declared.device.m
    q = np.concatenate([r.notes["position"] for r in replays], axis=1)
    speed = np.concatenate([r.notes["speed"] for r in replays], axis=1)
    low, middle, high = np.quantile(q, (0.05, 0.5, 0.95), axis=1)
    signals = TipSignals()
    force = [np.hypot(*(r.inputs[name] for name in signals.force)) for r in replays]
    commands = [max(float(r.inputs[f"{signals.command}_{i + 1}"].max()) for r in replays)
                for i in range(m)]  # fmt: skip
    return TipReach(
        middle, 0.5 * (high - low), np.quantile(np.abs(speed), 0.95, axis=1),
        evaluated(declared, "clutch_map", middle, (m, n)),
        float(np.quantile(np.concatenate(force), 0.99)), np.array(commands),
        max(float(r.time[-1]) for r in replays), row_step(replays[0].time),
    )  # fmt: skip


def planned_recording(
    recording: Recording, model: Scenario, reach: TipReach
) -> tuple[Recording, dict[str, dict[str, np.ndarray]]]:
    """What a recording of all planned experiments would hold, by this model; what is laid down.

    Parameters
    ----------
    recording : Recording
        Its map and the noise of its channels are taken over.
    model : Scenario
    reach : TipReach
    """
    plans = tip_experiments(reach)
    tips = [over_poses(model.device, "tip", plan.pose.T, 2).T for plan in plans]
    hand = _hand(model, reach, tips)
    template = PATH.template(model)
    pushed = (hand if isinstance(x, ReplayedTipForce) else x for x in template.loads)
    runner = ScenarioRunner(replace(template, loads=tuple(pushed)))
    told = model.switching()  # effects change delays and thresholds
    switching = np.array([*told["delay"], *told["threshold"]])
    generator = np.random.default_rng(1)
    runs: list[RecordedRun] = []
    asked: dict[str, dict[str, np.ndarray]] = {}
    signals = TipSignals()
    for plan, tip in zip(plans, tips, strict=True):
        channels = _simulated(runner, switching, hand, reach, plan, tip)
        if not all(np.isfinite(x).all() for x in channels.values()):
            continue  # the device would be carried into a singular pose
        number = sum(r.experiment == plan.experiment for r in runs) + 1
        name = f"{plan.experiment}: {number}"
        noisy = {
            c: x + generator.normal(0.0, _noise(recording, c), x.size) for c, x in channels.items()
        }
        runs.append(
            RecordedRun(name, plan.experiment, name, (0, reach.time.size), reach.time, noisy)
        )
        asked[name] = {f"{signals.position}_{j + 1}": x for j, x in enumerate(plan.pose)}
        asked[name] |= {f"{signals.command}_{i + 1}": x for i, x in enumerate(plan.commands)}
    # However the force was played, a sensor sees what an arm does.
    mapped = {
        name: replace(one, held="sampled") if name in signals.force else one
        for name, one in recording.channels.items()
    }
    planned = replace(recording.map, channels=mapped)
    return replace(recording, source="planned", map=planned, runs=tuple(runs), findings=()), asked


def _hand(model: Scenario, reach: TipReach, tips: Sequence[np.ndarray]) -> FollowingHand:
    """An arm that can follow and does not push harder than was pushed."""
    n = len(reach.middle)
    way = max(float(np.ptp(tip, axis=1).max()) for tip in tips)
    stiffness = reach.force / (GIVES * way)
    inertia = evaluated(model, "mass_matrix", reach.middle, (n, n))
    turn = evaluated(model, "tip_jacobian", reach.middle, (2, n))
    light = np.linalg.eigvalsh(turn @ np.linalg.solve(inertia, turn.T))[-1]
    return FollowingHand(stiffness, 2.0 * DAMPED * float(np.sqrt(stiffness / light)), reach.force)


def _simulated(
    runner: ScenarioRunner, switching: np.ndarray, hand: FollowingHand, reach: TipReach,
    plan: TipPlan, tip: np.ndarray,
) -> dict[str, np.ndarray]:  # fmt: skip
    """Every channel of one run without noise."""
    n, m = runner.program.z["n"], runner.program.z["m"]
    signals = TipSignals()
    inputs = {f"{signals.command}_{i + 1}": plan.commands[i] for i in range(m)}
    path = dict(zip(PATH.signals.force, tip, strict=True))
    run = Replay(plan.experiment, plan.experiment, reach.time, {**inputs, **path}, {})
    data = PATH.pack(run, runner.scenario.period)
    start = [*plan.pose[:, 0], *np.zeros(n)]
    begun = GivenRun(
        runner.default, switching, data, reach.time, start=start, excitation=PATH.excited(run)
    )
    rows, _ = runner.run(begun)
    q, qd = rows[:, :n], rows[:, n : 2 * n]
    rate = np.gradient(tip, reach.step, axis=1)
    made = dict(inputs)
    for j in range(n):
        made[f"{signals.position}_{j + 1}"] = q[:, j]
    device = runner.scenario.device
    seen = over_poses(device, "tip", q, 2).T
    turn = over_poses(device, "tip_jacobian", q, 2 * n).T.reshape(2, n, -1)
    moving = np.einsum("kjs,sj->ks", turn, qd)
    wanted = hand.stiffness * (tip - seen) + hand.damping * (rate - moving)
    share = [gives_way(x, y, hand.limit) for x, y in wanted.T.tolist()]
    made |= dict(zip(signals.force, wanted * share, strict=True))
    return made


def _noise(recording: Recording, name: str) -> float:
    """Standard deviation of a channel's noise [SI]; commands have none."""
    sampled = recording.channels[name].held == "sampled"
    return channel_noise(recording, name) if sampled else 0.0
