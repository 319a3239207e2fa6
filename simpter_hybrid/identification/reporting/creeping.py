"""Windows in which the record moves on while the model rests, which no error tells.

Where positions alone were logged the speed with which a window begins is known badly, and of a
straight line in what is left half of the way counts for nothing.  A joint that creeps under a force
too small for its friction (what yields before it slides, a soft mount) leaves just that.
"""

from __future__ import annotations

from ..held_out_predictions import HeldOutPredictions
from ..recordings.recording import Recording
from ..window_ways import window_ways

#: Fewest such windows, and part of all, that are told.
FEWEST, PART = 3, 0.1


def creeping_sentence(told: HeldOutPredictions, recording: Recording) -> str:
    """How many windows of the runs held out creep while the model rests; "" if few do."""
    for channel in dict.fromkeys(c for replay in told.replays for c in replay.observed):
        gone = [
            abs(way.gone) if way.rests else 0.0
            for i, replay in enumerate(told.replays)
            if channel in replay.observed
            for way in window_ways(replay.observed[channel], told.after[channel][i])
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
