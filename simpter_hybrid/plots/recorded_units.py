"""Units of a recording, for what is drawn of it."""

from __future__ import annotations

from collections.abc import Callable

from ..identification.recordings.recording import Recording


def units(recording: Recording | None, channel: str) -> tuple[str, Callable]:
    """Unit of a channel in its recording and what turns SI values into it."""
    if recording is None or channel not in recording.channels:
        return "SI", lambda values: values
    c = recording.channels[channel]
    return c.unit, lambda values: (c.sign * values - c.shift) / c.unit_scale


def difference_units(recording: Recording | None, channel: str) -> tuple[str, Callable]:
    """Unit of a channel and what turns a difference of two SI values into it: without the shift."""
    unit, written = units(recording, channel)
    return unit, lambda values: written(values) - written(0.0)
