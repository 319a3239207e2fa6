"""Selecting runs that go where no fitted run went: of what acts there no fit knows the size."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from ...units import is_unit
from ..fitting.replay import Replay
from ..recordings.channel_map import ChannelMap
from ..recordings.recording import Recording
from ..result import Diagnosis
from ..tracing.verdict import LACKING

#: Selecting runs go beyond the fitted ones by this part of what these go through.
BEYOND = 0.5
#: Of a course that much is its reach: a jump is none.
MOST = 0.99
#: What turns this far comes to every place [rad].
TURN = 2.0 * np.pi
#: Parts of a turn in which fitted runs have been.
SECTORS = 12


def beyond_fitted_sentence(found: Diagnosis, taken: Recording) -> str:
    """Sentence on places or speeds to which only selecting runs go; "" where there are none.

    Asked where something is left: what begins beyond the reach of the fitted runs looks unknown.
    """
    if found.search.verdict.kind not in (*LACKING, "form incomplete"):
        return ""
    said = []
    for name, ends in (("position", _places), ("speed", _speeds)):
        fitted, selecting = (_reach(r, name, ends) for r in (found.fitted, found.split.select))
        if fitted is None or selecting is None or name not in taken.channels:
            continue
        channel, size = taken.channels[name], fitted[1] - fitted[0]
        beyond = max(fitted[0] - selecting[0], selecting[1] - fitted[1])
        again = channel.wraps > 0.0 and _passed(found, name, channel.wraps)
        turned = is_unit(channel.unit, "angle") and (size >= TURN or again)
        if beyond > BEYOND * size > 0.0 and not turned:
            told = _told if name == "position" else _told_speed
            said.append(f"{name} {told(channel, selecting)}, against {told(channel, fitted)}")
    if not said:
        return ""
    return (
        f"The runs that select go where no fitted one went ({'; '.join(said)}): what acts there no "
        "fit can size. Let runs that go as far fit as well."
    )


def _passed(found: Diagnosis, name: str, turn: float) -> bool:
    """Whether fitted runs passed all places of selecting ones, in whatever turn each began."""
    fitted, selecting = (
        np.concatenate([r.notes[name] for r in runs]) for runs in (found.fitted, found.split.select)
    )
    of_fitted, of_selecting = (
        np.floor(SECTORS * (x / turn % 1.0)) % SECTORS for x in (fitted, selecting)
    )
    return bool(np.mean(np.isin(of_selecting, of_fitted)) >= MOST)


def _reach(
    runs: Sequence[Replay], name: str, ends: Callable[[np.ndarray], tuple[float, float]]
) -> tuple[float, float] | None:
    courses = [r.notes[name] for r in runs if name in r.notes]
    if not courses or any(x.ndim != 1 for x in courses):
        return None
    return ends(np.concatenate(courses))


def _places(x: np.ndarray) -> tuple[float, float]:
    low, high = np.quantile(x, (1.0 - MOST, MOST)).tolist()
    return low, high


def _speeds(v: np.ndarray) -> tuple[float, float]:
    return 0.0, float(np.quantile(np.abs(v), MOST))


def _told(channel: ChannelMap, ends: tuple[float, float]) -> str:
    """An interval in the unit of the record."""
    low, high = sorted(channel.in_unit(x) for x in ends)
    return f"{low:.3g} to {high:.3g}{channel.suffix}"


def _told_speed(channel: ChannelMap, ends: tuple[float, float]) -> str:
    """How fast, either way."""
    return f"up to {ends[1] / abs(channel.unit_scale):.3g}{channel.suffix}"
