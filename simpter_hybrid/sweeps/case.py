"""One case of a sweep: its name by content, and what is kept of it."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from .base import fingerprint

FORMAT = "simpter_hybrid sweep case 1"
#: Outcomes of a run that went as the scenario says.
GOOD = ("finished", "stopped")


@dataclass(frozen=True)
class Record:
    """What is kept of a case.

    Parameters
    ----------
    case : str
        Its name.
    given : mapping of str to str
        The values that make it this case, by path.
    status : str
        ``finished`` or ``stopped``; ``failed``: the simulation failed; ``invalid``: the values
        were refused; ``error``: the program failed; ``killed``: its process died twice, alone.
    message : str
    time : float or None
        Instant at which the run ended [s]; None where none began.
    measures : mapping of str to float or None
        Empty unless the run went well.
    """

    case: str
    given: Mapping[str, str]
    status: str
    message: str
    time: float | None = None
    measures: Mapping[str, float | None] = ()  # type: ignore[assignment]

    @property
    def good(self) -> bool:
        """Whether the run went well."""
        return self.status in GOOD

    def to_bytes(self) -> bytes:
        """The content of its file; the same record gives the same bytes."""
        found = {
            "format": FORMAT, "case": self.case, "set": dict(self.given), "status": self.status,
            "message": self.message, "time_s": self.time,
            "measures": {name: plain(value) for name, value in dict(self.measures).items()},
        }  # fmt: skip
        return (json.dumps(found, indent=1, allow_nan=False) + "\n").encode()


def plain(value: Any) -> float | int | None:
    """A number for JSON; what is not finite becomes None.

    Parameters
    ----------
    value : object
        A number of Python or NumPy, or None.
    """
    value = value.item() if hasattr(value, "item") else value
    if value is None or not math.isfinite(value):
        return None
    return float(value) if isinstance(value, float) else int(value)


def record_of(content: bytes) -> Record | None:
    """The record in a file's content; None where it is damaged or something else.

    Parameters
    ----------
    content : bytes
        As ``Record.to_bytes`` makes it.
    """
    try:
        found = json.loads(content)
        if found["format"] != FORMAT:
            return None
        return Record(
            found["case"], found["set"], found["status"], found["message"], found["time_s"],
            found["measures"],
        )  # fmt: skip
    except (ValueError, KeyError, TypeError):
        return None


def case_name(base: str, given: Sequence[tuple[str, str]], options: str) -> str:
    """Name of a case: 40 digits of the fingerprint of all that its result depends on.

    Parameters
    ----------
    base : str
        Fingerprint of the scenario that is varied.
    given : sequence of (path, value)
        A value that names a file stands for that file's content.
    options : str
        Fingerprint of engine, measures and program.
    """
    return fingerprint(base, sorted(given), options)[:40]
