"""``[[stops]]`` of a scenario file, read and written: with a stop before singular poses, or not."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ..device import Device
from ..part import Part
from ..stop import Singular
from .fields import Context
from .reader import TableReader
from .sections import read_list


def read_stops(root: TableReader, context: Context) -> tuple[Part, ...]:
    """``[[stops]]``; one before singular poses is added unless the file has its own.

    None is added to ``stops = []``, nor to any with ``default_stops = false``.
    """
    stops = read_list(root, "stops", "stop", context)
    added = root.boolean("default_stops", root.data.get("stops") != [])
    return (*stops, Singular()) if added and _lacks_one(stops, context.device) else stops


def written_without(stops: Sequence[Part], device: Device) -> dict[str, Any]:
    """Keys that keep `read_stops` from adding a stop to those of a scenario; often none.

    Parameters
    ----------
    stops : sequence of Part
    device : Device
    """
    if not _lacks_one(stops, device):
        return {}
    return {"default_stops": False} if stops else {"stops": []}


def _lacks_one(stops: Sequence[Part], device: Device | None) -> bool:
    """Whether a device has singular poses, and none of the stops is before them."""
    has = device is not None and "singularity" in device.functions()
    return has and not any(isinstance(stop, Singular) for stop in stops)
