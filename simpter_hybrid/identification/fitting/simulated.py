"""Whether a declared model can be simulated through what it is to be compared with."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from ...problems import InvalidInput, Problem
from .predictor import Predictor
from .replay import Replay

#: A model that fails in more than this part of the samples says nothing of a recording.
LOST = 0.5


def check_simulated(
    predictor: Predictor, values: Mapping[str, float], replays: Sequence[Replay], name: str
) -> None:
    """Check that a model can be simulated through most of what is compared.

    Raises
    ------
    InvalidInput
        If the model fails in more than the part `LOST` of the samples.
    """
    predicted = predictor.predict(values, replays)
    channels = {c for r in replays for c in r.observed}
    lost = [np.isnan(series) for c in channels for series in predicted[c]]
    part = float(np.mean(np.concatenate(lost)))
    if part > LOST:
        what = "the declared model cannot be simulated over the runs that fit"
        right = "a model that `simpter run` finishes, also with these runs' drive"
        raise InvalidInput([Problem(name, "", what, f"{100 * part:.0f} % of the samples", right)])
