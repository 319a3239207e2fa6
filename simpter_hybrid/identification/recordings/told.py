"""What a driver was told drives, whatever its map calls it: no rig compares it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from .channel_map import ChannelMap
from .checks import Finding
from .map_file import RecordingMap

#: Set points and commands of one axis, by their names; a force or a current is a sensor's, and of
#: an axis that a tester moves it is compared.
TOLD = ("drive", "duty", "reference")


def as_told(described: RecordingMap) -> tuple[RecordingMap, list[Finding]]:
    """The map with what drives an axis as an input, and remarks on what it called measured.

    Checks of a sensor would ask whether a command that stays at its limit was cut off.  What has
    no cells in some runs stays, and so does all of an axis that is moved or let alone.
    """
    channels = described.channels
    if not described.driven or _moved(channels):
        return described, []
    wrong = {
        name: channel
        for name, channel in channels.items()
        if name in TOLD and channel.role == "measured" and not channel.optional
    }
    inputs = {name: replace(channel, role="input") for name, channel in wrong.items()}
    return replace(described, channels={**channels, **inputs}), [_remark(n) for n in wrong]


def _moved(channels: Mapping[str, ChannelMap]) -> bool:
    return any(n in channels and channels[n].role == "input" for n in ("position", "speed"))


def _remark(name: str) -> Finding:
    what = f"{name} is called measured, but it drives: it is played as an input, and not compared"
    return Finding.of_all(what, 'role = "measured"', 'role = "input"')
