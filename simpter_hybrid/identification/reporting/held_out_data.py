"""What a report shows of the runs held out beside the errors of whole channels."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict
from math import isfinite
from typing import Any

import numpy as np

from ..diagnosis import Found
from ..fitting.lack_of_fit import lack_of_fit, replicate_noise, residual_series
from ..fitting.residual import errors_by_experiment
from ..held_out_gains import HeldOutGain
from ..recordings.noise import channel_noise
from ..recordings.recording import Recording


def models_of(found: Found) -> dict[str, tuple[Any, Mapping[str, float]]]:
    """Predictor and values of the refitted and the corrected model."""
    done = found.diagnosis
    return {
        "refitted": (done.declared.predictor, done.declared.values),
        "after": (done.corrected.predictor, done.corrected.values),
    }


def errors_of_experiments(found: Found) -> dict[str, dict[str, float]]:
    """Experiment -> stage -> error on its runs held out, over the floor."""
    rows: dict[str, dict[str, float]] = {}
    for stage, (predictor, values) in models_of(found).items():
        _, apart = errors_by_experiment(predictor, values, found.split.report)
        for experiment, error in apart.items():
            rows.setdefault(experiment, {})[stage] = error / found.diagnosis.floor
    return rows


def lack_of_fit_rows(found: Found) -> dict[str, dict[str, float | None]]:
    """Stage -> test of what it leaves of the runs held out against what repeated runs differ by."""
    noise, rows = replicate_noise(found.fitted), {}
    for stage, (predictor, values) in models_of(found).items():
        left = residual_series(predictor, values, found.split.report)
        test = asdict(lack_of_fit(left, noise, found.diagnosis.floor))
        told = {name: value if isfinite(value) else None for name, value in test.items()}
        rows[stage] = told | {"samples": sum(series.size for series in left)}
    return rows


def noise_of_channels(found: Found, recording: Recording) -> dict[str, float]:
    """Channel -> standard deviation of its noise over the runs held out [SI].

    That of a run by which residuals count may be larger: it may hold what the noise of inputs does
    to a prediction, or what the declared model leaves.
    """
    square: dict[str, list[float]] = {}
    for replay in found.split.report:
        for channel, seen in replay.observed.items():
            square.setdefault(channel, []).append(float(np.mean(np.square(seen.sd))))
    weighed = {channel: float(np.sqrt(np.mean(every))) for channel, every in square.items()}
    return {
        channel: min(sd, channel_noise(recording, channel)) if channel in recording.channels else sd
        for channel, sd in weighed.items()
    }


def breakaway_rows(found: Found) -> list[dict[str, Any]]:
    """Levels at which stuck clutches let go in the runs held out, measured and predicted [N m]."""
    runs, rows = found.split.report, []
    if not any(r.breakaways for r in runs):
        return []
    held = {
        stage: predictor.predict(values, runs)["breakaway_torque"]
        for stage, (predictor, values) in models_of(found).items()
    }
    for i, replay in enumerate(runs):
        for event in replay.breakaways:
            before = max(event.index - 1, 0)
            rows.append({
                "run": replay.name, "time": float(replay.time[event.index]),
                "rested": event.rested, "measured": abs(event.level), "sd": event.sd,
                **{stage: float(levels[i][before]) for stage, levels in held.items()},
            })  # fmt: skip
    return rows


def gain_rows(gains: Sequence[HeldOutGain]) -> dict[str, dict[str, float]]:
    """Candidate -> its gain on the runs held out, and the ends of the interval."""
    return {g.name: {"gain": g.gain, "low": g.low, "high": g.high} for g in gains}
