"""What a report shows of the runs held out beside the errors of whole channels."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from math import isfinite
from typing import Any

import numpy as np

from ..fitting.floor import Weighed, weighted_floor
from ..fitting.lack_of_fit import lack_of_fit, residual_series
from ..held_out_gains import HeldOutGain
from ..held_out_predictions import HeldOutPredictions, noise_of
from ..recordings.recording import Recording
from ..result import Diagnosis


def not_compared(found: Diagnosis, taken: Recording) -> list[str]:
    """Measured channels that no error is told of; a position summed up from a speed is none."""
    measured = (n for n, c in taken.channels.items() if c.role == "measured" and not c.summed)
    return [name for name in measured if name not in found.errors["after"]]


def errors_of_experiments(found: Diagnosis) -> dict[str, dict[str, float]]:
    """Experiment -> stage -> error on its runs held out, over the floor.

    ``floor``: what repeated runs of it differ by among the fitted ones, over the floor.
    """
    rows: dict[str, dict[str, float]] = {}
    compared = {r.experiment for r in found.split.report if r.compared}
    for stage, apart in found.error_by_experiment.items():
        for experiment, error in ((n, e) for n, e in apart.items() if n in compared):
            rows.setdefault(experiment, {})[stage] = error / found.floors.report
    for experiment, row in rows.items():
        own = weighted_floor([r for r in found.fitted if r.experiment == experiment])
        if isfinite(own):
            row["floor"] = own / found.floors.report
    return rows


def lack_of_fit_rows(
    told: HeldOutPredictions, noise: Sequence[Weighed], floor: float
) -> dict[str, dict[str, float | None]]:
    """Stage -> test of what it leaves of the runs held out against what repeated runs differ by."""
    rows = {}
    for stage, predicted in told.stages.items():
        left = residual_series(predicted, told.replays)
        test = asdict(lack_of_fit(left, noise, floor))
        finite = {name: value if isfinite(value) else None for name, value in test.items()}
        rows[stage] = finite | {"samples": sum(series.values.size for series in left)}
    return rows


def noise_of_channels(told: HeldOutPredictions, recording: Recording) -> dict[str, float]:
    """Channel -> standard deviation of its noise over the runs held out [SI]."""
    found: dict[str, list[float]] = {}
    for replay in told.replays:
        for channel, seen in replay.observed.items():
            sd = np.asarray(noise_of(recording, channel, seen, replay.time))
            found.setdefault(channel, []).append(float(np.mean(sd**2)))
    return {channel: float(np.sqrt(np.mean(every))) for channel, every in found.items()}


def breakaway_rows(told: HeldOutPredictions) -> list[dict[str, Any]]:
    """Levels at which stuck clutches let go in the runs held out, measured and predicted [N m]."""
    rows = []
    for i, replay in enumerate(told.replays):
        for event in replay.breakaways:
            before = max(event.index - 1, 0)
            levels = {
                stage: float(predicted["breakaway_torque"][i][before])
                for stage, predicted in told.stages.items()
            }
            rows.append({
                "run": replay.name, "time": float(replay.time[event.index]),
                "rested": event.rested, "measured": abs(event.level), "sd": event.sd, **levels,
            })  # fmt: skip
    return rows


def gain_rows(gains: Sequence[HeldOutGain]) -> dict[str, dict[str, float | bool | None]]:
    """Candidate -> its gain on the runs held out, and the ends of the interval, None without one.

    ``of_runs``: whether that holds for other such runs, or within these alone.
    """
    return {
        g.name: {
            "gain": g.gain, "low": g.low if g.has_interval else None,
            "high": g.high if g.has_interval else None, "of_runs": g.of_runs,
        }
        for g in gains
    }  # fmt: skip
