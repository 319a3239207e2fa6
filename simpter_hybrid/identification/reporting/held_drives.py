"""What is said of a drive that the map holds from row to row."""

from __future__ import annotations

from ..axis.force_sensor import TIMING
from ..axis.signals import AxisSignals
from ..recordings.recording import Recording
from ..result import Diagnosis
from .cautions import between_rows_sentence


def held_drives_sentence(found: Diagnosis, recording: Recording) -> str:
    """`between_rows_sentence` and `held_sensor_sentence`, as far as there is something to tell."""
    said = (
        between_rows_sentence(recording, found.search.verdict),
        held_sensor_sentence(found, recording),
    )
    return " ".join(filter(None, said))


def held_sensor_sentence(found: Diagnosis, recording: Recording) -> str:
    """Sentence that a late sensor's reading is held by the map; "" where none is.

    What a sensor shows late goes on between rows whatever drove.  A torque behind a lag of 15 ms,
    held from row to row of 4 ms, was a lag and an elastic part, and sampled the lag alone.
    """
    late = [
        e.listed_as for e in found.search.corrected.effects
        if any(p.name in TIMING for p in e.parameters)
    ]  # fmt: skip
    held = [
        name for name, channel in recording.channels.items()
        if channel.role == "input" and channel.held != "sampled"
        and name.startswith((*AxisSignals().sensed,))
    ]  # fmt: skip
    if not late or not held:
        return ""
    return (
        f"The map holds {' and '.join(held)} from row to row, but what a sensor shows late goes on "
        f"between rows: if it was read, and not set, take `held` out of the map and diagnose again "
        f"({' and '.join(late)}, and what is named beside it, may be another size or go)."
    )
