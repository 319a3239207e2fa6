"""``trajectory.npz`` read back: all of it, or why it cannot be."""

from __future__ import annotations

import json
import zipfile
import zlib
from collections.abc import Iterable, Mapping
from dataclasses import MISSING, fields
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from ..trajectory import Event, Trajectory

FORMAT = "simpter_hybrid run 1"
#: Member of ``trajectory.npz`` that holds what is not an array.
ABOUT = "about.json"
#: What NumPy, zipfile and json raise of files that are cut off, empty or of something else.
DAMAGED = (
    OSError, EOFError, KeyError, TypeError, ValueError, RuntimeError, zipfile.BadZipFile, zlib.error
)  # fmt: skip


class StoredRunError(ValueError):
    """A stored run that cannot be read."""


class Archive(NamedTuple):
    """What a file holds: fields of the ``Trajectory``, and what tells the scenario that was run."""

    values: dict[str, Any]
    parameters: Mapping[str, float]
    identity: Mapping[str, Any]


def read_archive(file: Path) -> Archive:
    """Everything that ``storage.trajectory_bytes`` wrote.

    Parameters
    ----------
    file : Path

    Raises
    ------
    StoredRunError
        If the file is missing, damaged, of another version, or no run at all.
    """
    try:
        with np.load(file, allow_pickle=False) as stored:
            about = json.loads(stored[ABOUT])
            version = about.pop("format")
            arrays = {name: stored[name] for name in stored.files if name != ABOUT}
    except FileNotFoundError:
        raise StoredRunError(
            f"{file.parent} holds no {file.name}; give the directory of a finished run"
        ) from None
    except DAMAGED as error:
        raise _unreadable(file, error) from error
    if version != FORMAT:
        raise StoredRunError(
            f"{file} was written by another version of the program; run the scenario again"
        )
    try:
        parameters = about.pop("parameters")
        identity = about.pop("scenario", {})  # not in runs saved before it was compared
        events = tuple(_event(entry) for entry in about.pop("events"))
    except DAMAGED as error:
        raise _unreadable(file, error) from error
    values = {**arrays, **about, "events": events}
    _check_whole(file, values)
    return Archive(values, parameters, identity)


def _unreadable(file: Path, error: BaseException) -> StoredRunError:
    return StoredRunError(f"{file} cannot be read ({error}); run the scenario again")


def _event(entry: Mapping[str, Any]) -> Event:
    made: dict[str, Any] = {
        name: tuple(v) if isinstance(v, list) else v for name, v in entry.items()
    }
    return Event(**made)


def _check_whole(file: Path, values: Iterable[str]) -> None:
    """Refuse a file without a field of the trajectory, or with one that is none."""
    known = [f for f in fields(Trajectory) if f.name != "scenario"]
    lacking = [f.name for f in known if f.name not in values and f.default is MISSING]
    if lacking:
        raise StoredRunError(
            f"{file} is damaged: it holds no {', '.join(lacking)}; run the scenario again"
        )
    unknown = sorted(set(values) - {f.name for f in known})
    if unknown:
        raise StoredRunError(
            f"{file} holds {', '.join(unknown)}, which no run of this version has; "
            "run the scenario again"
        )
