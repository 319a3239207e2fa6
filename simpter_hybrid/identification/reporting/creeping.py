"""Windows in which the record moves on while the model rests, which no error tells.

Where positions alone were logged the speed with which a window begins is known badly, and of a
straight line in what is left half of the way counts for nothing.  A joint that creeps under a force
too small for its friction (what yields before it slides, a soft mount) leaves just that.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ..fitting.replay import Observation
from ..held_out_predictions import HeldOutPredictions
from ..recordings.recording import Recording

#: In such a window the record goes farther by so many deviations of the means of its first and last
#: quarter, and the model moves by less than this part of that.
FAR, RESTS = 8.0, 0.25
#: Fewest such windows, and part of all, that are told.
FEWEST, PART = 3, 0.1


def creeping_sentence(told: HeldOutPredictions, recording: Recording) -> str:
    """How many windows of the runs held out creep while the model rests; "" if few do."""
    for channel in dict.fromkeys(c for replay in told.replays for c in replay.observed):
        gone = [
            moved
            for i, replay in enumerate(told.replays)
            if channel in replay.observed
            for moved in _gone(replay.observed[channel], told.after[channel][i])
        ]
        creeps = [moved for moved in gone if moved > 0.0]
        if len(creeps) >= max(FEWEST, PART * len(gone)):
            most = recording.channels[channel].written_size(max(creeps))
            return (
                f"In {len(creeps)} of {len(gone)} windows of the runs held out the {channel} goes "
                f"on by up to {most} while the model rests. Of positions alone half of "
                "such a way counts as the error of a window's start, so a creep (what yields "
                "before it slides) is hardly seen: log the speed as well, or take the "
                "position as an input and the force as measured."
            )
    return ""


def _gone(seen: Observation, predicted: np.ndarray) -> Iterator[float]:
    """How far each window of a channel goes while the model rests in it; 0 where it does not."""
    if not seen.lines or not seen.windows:
        return
    for a, b in zip(seen.windows, (*seen.windows[1:], seen.values.size), strict=True):
        kept = seen.keep[a:b]
        values, model = seen.values[a:b][kept], predicted[a:b][kept]
        rows = max(1, values.size // 4)
        if values.size < 2 * rows:
            yield 0.0
            continue
        gone = float(abs(np.mean(values[-rows:]) - np.mean(values[:rows])))
        far = gone > FAR * seen.own * seen.sd * np.sqrt(2.0 / rows)
        yield gone if far and np.ptp(model) < RESTS * gone else 0.0
