"""What is simulated of the runs that are asked for: each, or pieces of one run together.

A model without memory is simulated from the first row of each piece.  One that remembers what was
before (`Replay.led_in`) is simulated from the beginning of the run that was cut; once for all of
its pieces, to the end of the last one asked for.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from ..fitting.replay import Replay


class SimulatedRun(NamedTuple):
    """One run of the model, and (number of what is asked for, its first row in the run) of each.

    `pieces`: of how many it is made.
    """

    run: Replay
    parts: tuple[tuple[int, int], ...]
    pieces: int = 1


def simulated_runs(replays: Sequence[Replay], remembers: bool) -> list[SimulatedRun]:
    """Runs that show all `replays`; `remembers`: whether what was before a piece matters."""
    if not remembers:
        return [SimulatedRun(r, ((i, 0),)) for i, r in enumerate(replays)]
    longest: dict[tuple, tuple[int, int, int]] = {}  # rows of the whole, its number, first row
    for i, replay in enumerate(replays):
        rows = replay.rows_before + replay.time.size
        for piece, first in _pieces(replay):
            if piece is replay or _alike(piece, replay):
                key = _course(piece)
                longest[key] = max(longest.get(key, (0, 0, 0)), (rows, i, first))
    parts: dict[int, list[tuple[int, int]]] = {}
    for i, replay in enumerate(replays):
        _, whole, first = longest[_course(replay)]
        if whole == i or not _alike(replay, replays[whole]):
            whole, first = i, replay.rows_before
        parts.setdefault(whole, []).append((i, first))
    # What another shows is not simulated; and nothing is shown by what itself is shown by another,
    # for that one is longer and shows both.
    runs = ((replays[i], tuple(of)) for i, of in parts.items())
    return [SimulatedRun(r.led_in, of, sum(1 for _ in _pieces(r))) for r, of in runs]


def _pieces(replay: Replay) -> Iterator[tuple[Replay, int]]:
    """A piece and all before it, with their first rows in the whole."""
    piece: Replay | None = replay
    while piece is not None:
        yield piece, piece.rows_before
        piece = piece.before


def _course(replay: Replay) -> tuple[int, int, int]:
    """What tells runs of one course: the record that they hold is the same object."""
    return id(replay.inputs), id(replay.notes), id(replay.restarts)


def _alike(piece: Replay, replay: Replay) -> bool:
    """Whether the model would do the same in the piece alone and in front of another."""
    free = (r.own or r.followed or r.start_free for r in (piece, replay))
    told = piece.added == replay.added and piece.setting == replay.setting
    return told and not any(free)
