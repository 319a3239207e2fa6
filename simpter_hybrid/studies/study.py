"""What a study hands over: tables, sentences made from their numbers, a picture."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True)
class Table:
    """A table of a study.

    Parameters
    ----------
    caption : str
    columns : tuple of str
        Headings, units in them.
    rows : tuple of tuple of str
    """

    caption: str
    columns: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]

    def __post_init__(self) -> None:
        wrong = [row for row in self.rows if len(row) != len(self.columns)]
        if wrong:
            raise ValueError(
                f"table {self.caption!r}: a row of {len(wrong[0])} cells under "
                f"{len(self.columns)} headings"
            )


@dataclass(frozen=True)
class Study:
    """One question, and what the runs say.

    Parameters
    ----------
    title, source : str
        What is asked, and where the thesis asks it.
    setup : str
        What was run, and what about it is assumed.
    tables : tuple of Table
    findings : tuple of str
        Sentences whose numbers and verdicts are computed.
    numbers : mapping
        What stands behind them, for files and tests.
    picture : callable, optional
        Draws a matplotlib figure.
    caption : str
        Of the picture.
    files : mapping of str to str
        Further files that belong to the study, by name.
    """

    title: str
    source: str
    setup: str
    tables: tuple[Table, ...]
    findings: tuple[str, ...]
    numbers: dict[str, Any] = field(default_factory=dict)
    picture: Callable[[], Any] | None = None
    caption: str = ""
    files: dict[str, str] = field(default_factory=dict)
