"""In what deviations residuals count where no run was repeated."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from .fitting.floor import replicate_pairs
from .fitting.replay import Replay
from .rigs.scenario_predictor import ScenarioPredictor


def scaled(
    parts: Mapping[str, list[Replay]], predictor: ScenarioPredictor, values: Mapping[str, float]
) -> tuple[dict[str, list[Replay]], float]:
    """Deviations not below what the declared model leaves, where there are no replicates.

    Without replicates the scale of a residual that a good model would leave is not known; noise
    alone is far below it, and residuals clipped at some of its deviations would steer the fit.
    Returns the replays and the ratio (root mean square) of the noise to the deviations used.
    """
    predicted = predictor.predict(values, parts["fit"])
    if replicate_pairs(parts["fit"]):
        return dict(parts), 1.0
    left: dict[str, list[np.ndarray]] = {}
    for i, replay in enumerate(parts["fit"]):
        for channel, seen in replay.observed.items():
            error = np.abs(seen.values - predicted[channel][i]) / seen.sd
            left.setdefault(channel, []).append(error[np.isfinite(error) & seen.keep])
    ratio = {c: max(1.0, 1.4826 * float(np.median(np.concatenate(e)))) for c, e in left.items()}
    found = {
        k: [
            replace(r, observed={c: replace(o, sd=o.sd * ratio.get(c, 1.0))
                                 for c, o in r.observed.items()})
            for r in replays
        ]
        for k, replays in parts.items()
    }  # fmt: skip
    return found, float(np.sqrt(np.mean([r**-2.0 for r in ratio.values()])))
