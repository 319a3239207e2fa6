"""Units of a recording, for what is drawn of it."""

from __future__ import annotations

from collections.abc import Callable

from ..identification.recordings.recording import Recording


def units(recording: Recording | None, channel: str) -> tuple[str, Callable]:
    """Unit of a channel in its recording and what turns SI values into it.

    Of a channel with an offset in the map the unit says that what is drawn has it.
    """
    if recording is None or channel not in recording.channels:
        return "SI", lambda values: values
    c = recording.channels[channel]
    unit = f"{c.unit}, as recorded" if c.shift else c.unit
    return unit, lambda values: (c.sign * values - c.shift) / c.unit_scale


def difference_units(recording: Recording | None, channel: str) -> tuple[str, Callable]:
    """Unit of a channel and what turns a difference of two SI values into it: without the shift."""
    _, written = units(recording, channel)
    known = recording is not None and channel in recording.channels
    unit = recording.channels[channel].unit if recording is not None and known else "SI"
    return unit, lambda values: written(values) - written(0.0)
