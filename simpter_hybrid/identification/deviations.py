"""In what deviations residuals count where no run was repeated."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from .fitting.replay import Observation, Replay
from .fitting.replicates import replicates
from .rigs.scenario_predictor import ScenarioPredictor


def scaled(
    parts: Mapping[str, list[Replay]], predictor: ScenarioPredictor, values: Mapping[str, float]
) -> dict[str, list[Replay]]:
    """Widen each channel's standard deviation to the declared model's residual, without replicates.

    The residual is taken robustly (1.4826 times the median of its sizes), and a deviation is never
    made smaller.  Where runs are replicates nothing is changed.

    Without replicates the scale of a residual that a good model would leave is not known; noise
    alone is far below it, and residuals clipped at some of its deviations would steer the fit.
    What part of the deviation is noise then stands in each observation (`own`).
    """
    if replicates(parts["fit"]):
        return dict(parts)
    predicted = predictor.predict(values, parts["fit"])
    left: dict[str, list[np.ndarray]] = {}
    for i, replay in enumerate(parts["fit"]):
        for channel, seen in replay.observed.items():
            error = np.abs(seen.values - predicted[channel][i]) / seen.sd
            left.setdefault(channel, []).append(error[np.isfinite(error) & seen.keep])
    ratio = {c: max(1.0, 1.4826 * float(np.median(np.concatenate(e)))) for c, e in left.items()}

    def wider(channel: str, seen: Observation) -> Observation:
        times = ratio.get(channel, 1.0)
        return replace(seen, sd=seen.sd * times, own=seen.own / times)

    return {
        part: [
            replace(r, observed={c: wider(c, seen) for c, seen in r.observed.items()})
            for r in replays
        ]
        for part, replays in parts.items()
    }
