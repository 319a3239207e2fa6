"""Columns of a recording's files, as read."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import datetime

import numpy as np

from .channel_map import ChannelMap


def as_text(value: object) -> str:
    """A cell as the name of a run has it: 1 for 1.0, and every digit of a date."""
    return f"{value:.15g}" if isinstance(value, float) else str(value)


@dataclass(frozen=True)
class Places:
    """Where rows stand, to say it to a reader.

    Parameters
    ----------
    files : tuple of str
    first : tuple of int
        First row of each file, from 0.
    lines : ndarray (rows,)
        Lines of a text in which the rows stand, from 1; 0 of arrays.
    """

    files: tuple[str, ...]
    first: tuple[int, ...] = (0,)
    lines: np.ndarray = field(default_factory=lambda: np.zeros(0, int))

    @property
    def source(self) -> str:
        """The files, for a sentence."""
        more = f" and {len(self.files) - 1} more" if len(self.files) > 1 else ""
        return f"{self.files[0]}{more}"

    def of(self, row: int) -> str:
        """``file:line``, of arrays ``file row k``; of row -1 the files alone."""
        if row < 0:
            return self.source
        k = int(np.searchsorted(self.first, row, "right")) - 1
        line = self.lines[row] if row < self.lines.size else 0
        return f"{self.files[k]}{f':{line}' if line else f' row {row - self.first[k] + 1}'}"


@dataclass(frozen=True)
class Columns:
    """Columns of a table: `numbers` as floats (rows,), `texts` as strings (rows,).

    `blank` says of columns with blank cells which these are (rows,); there `numbers` are NaN.
    `places` says where the rows stand; `origin` is the date of time 0, where stamps are dates;
    `left_out` says where rows stood that are not in it; `written` how numbers by which runs are
    called stand in a text, of each column.
    """

    numbers: Mapping[str, np.ndarray]
    texts: Mapping[str, np.ndarray]
    size: int
    blank: Mapping[str, np.ndarray]
    places: Places
    origin: datetime | None = None
    left_out: tuple[str, ...] = ()
    written: Mapping[str, Mapping[float, str]] = field(default_factory=dict)

    def values(self, name: str) -> np.ndarray:
        """A column, whatever it holds."""
        return self.numbers[name] if name in self.numbers else self.texts[name]

    def applies(self, channel: ChannelMap, rows: tuple[int, int] | None = None) -> np.ndarray:
        """Mask of the rows to which a channel belongs, by its `where`.

        Parameters
        ----------
        channel : ChannelMap
        rows : tuple of int, optional
            First, and one past the last; default: all.

        Returns
        -------
        ndarray of bool (rows,)
        """
        span = slice(*(rows or (0, self.size)))
        if channel.where is None:
            return np.ones(span.stop - span.start, bool)
        column, equals = channel.where
        return self.numbers[column][span] == equals

    def of_channel(self, channel: ChannelMap, rows: tuple[int, int]) -> tuple[np.ndarray, ...]:
        """Numbers of a channel's column in those of some rows to which it belongs.

        Parameters
        ----------
        channel : ChannelMap
        rows : tuple of int
            First, and one past the last.

        Returns
        -------
        index, numbers : ndarray (n,)
            Rows, from 0 at the first of `rows`, and what stands there, as written.
        """
        index = np.flatnonzero(self.applies(channel, rows))
        return index, self.numbers[channel.column][slice(*rows)][index]
