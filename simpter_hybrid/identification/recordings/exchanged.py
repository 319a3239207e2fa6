"""A speed and a position that do not go together at all: are their columns exchanged?"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np
from scipy.stats import rankdata

from .agreement import FACTOR, SHORTER, SPAN, SURE, TELLING, Disagreement, Runs, beside, movements
from .channel_map import ChannelMap
from .checks import Finding
from .motion import Motion

#: Columns are exchanged if, as they are, so many times the part of the movements is unlike (all of
#: it where they go against each other) as exchanged: a late or a noisy speed agrees no better so,
#: and what swings goes against itself.
FAR = 4.0
#: A speed below this correlation with its position's movements tells next to nothing of them.
HARDLY = 0.5


def exchanged(runs: Runs, channels: Mapping[str, ChannelMap]) -> Iterator[Disagreement]:
    """Speeds of which the positions are the rates, at about the right scale, and not they of these.

    Parameters
    ----------
    runs : sequence of (ndarray (samples,), mapping of str to ndarray (samples,))
        Time stamps [s], and signal -> values [SI].
    channels : mapping of str to ChannelMap
    """
    for speed, position, span, alike in _alike(runs, channels):
        # A wrong sign is told already; a slow swing looks exchanged then, too.
        if alike <= -SURE:
            continue
        both = [(t, found) for t, found in runs if {speed, position} <= {*found}]
        turned = [movements(t, found[speed], found[position], span) for t, found in both]
        moved, expected, _ = (np.concatenate(part) for part in zip(*turned, strict=True))
        # Where all rests, a drift of the one is the integral of a constant that the other stays at.
        moved, expected = moved - moved.mean(), expected - expected.mean()
        so = _correlation(moved, expected)
        if so < SURE or not 1.0 / FACTOR < so * _size(moved) / _size(expected) < FACTOR:
            continue
        if 1.0 - max(alike, 0.0) ** 2 > FAR * (1.0 - so**2):
            right = f"1: are the columns of the two exchanged? (so it is {so:.2g})"
            yield Disagreement(speed, _what(speed, position), alike, right)


def hardly_together(
    runs: Runs, channels: Mapping[str, ChannelMap], moved: Mapping[str, Motion]
) -> list[Finding]:
    """Remarks on speeds that tell next to nothing of how the positions beside them move.

    Not of positions that hardly move: there a speed shows its noise, which is said elsewhere.
    """
    found = []
    for speed, position, _, alike in _alike(runs, channels):
        if alike < HARDLY and position in moved and not moved[position].little:
            right = "about 1: are both columns of one motion, and is the speed more than noise?"
            what = _what(speed, position)
            found.append(Finding.of_all(what, f"{alike:.2g}", right))
    return found


def _what(speed: str, position: str) -> str:
    return f"{position} and {speed} do not go together (correlation of how far it moves by either)"


def _alike(
    runs: Runs, channels: Mapping[str, ChannelMap]
) -> Iterator[tuple[str, str, float, float]]:
    """Speed, position, a span [s] of which there are movements enough, and their correlation.

    That of their ranks, if it is more: one blow that the position does not show is not all.
    """
    told = set()
    for span in (SPAN, *SHORTER):
        for speed, position, pairs in beside(runs, channels, span):
            moved, expected, _ = (np.concatenate(part) for part in zip(*pairs, strict=True))
            if speed not in told and moved.size >= TELLING:
                told.add(speed)
                ranks = (rankdata(way) - 0.5 * (way.size + 1) for way in (moved, expected))
                alike = max(_correlation(moved, expected), _correlation(*ranks))
                yield speed, position, span, alike


def _correlation(one: np.ndarray, other: np.ndarray) -> float:
    sizes = _size(one) * _size(other)
    return float(one @ other) / sizes if sizes > 0.0 else 0.0


def _size(values: np.ndarray) -> float:
    return float(np.linalg.norm(values))
