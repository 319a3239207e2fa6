"""The map of a recording: which column is which signal, in which unit and with which sign.

Nothing is guessed: a column without unit and sign in the map is not read.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from ...files.tomlfile import read_toml
from ...reading.reader import TableReader
from .channel_map import ChannelMap, read_channel
from .clock import COUNTED, Clock, read_clock
from .layout import Layout, read_layout
from .start import Start, read_start

#: Stands in a map for what is to be filled in.
OPEN = "?"
#: Column that every file has: its own name, unless one is called so.
FILE = "file"


@dataclass(frozen=True)
class RecordingMap:
    """A whole map; `split` says which groups fit, select and report.

    `only`: column -> text; runs in whose first row the column reads otherwise are left out.
    `driven`: False of an axis that is let alone.  `layout`: of a table of text.
    `by_file`: a file's name stands for the column `FILE`, which it lacks.  `pieces`: into so many
    runs, each a group, every run is cut.  `clock`: how time is told, where not by stamps.
    `span`: from when to when rows of a run count, from its first one [s].  `start`: what is known
    of the state in its first row.
    """

    source: str
    time: ChannelMap
    channels: Mapping[str, ChannelMap]
    run_columns: tuple[str, ...] = ()
    experiment_columns: tuple[str, ...] = ()
    group_columns: tuple[str, ...] = ()
    split: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    only: Mapping[str, str] = field(default_factory=dict)
    driven: bool = True
    layout: Layout = Layout()
    by_file: bool = False
    pieces: int = 1
    clock: Clock = Clock()
    span: tuple[float, float] = (0.0, np.inf)
    start: Start = Start()

    def present(self, columns: Iterable[str]) -> RecordingMap:
        """The map of a file with these columns: less optional channels that it lacks."""
        there = set(columns)
        absent = (s for s, c in self.channels.items() if c.optional and c.column not in there)
        return replace(self.without(absent), by_file=FILE not in there)

    def without(self, signals: Iterable[str]) -> RecordingMap:
        """The map less some signals."""
        gone = set(signals)
        return replace(self, channels={s: c for s, c in self.channels.items() if s not in gone})

    def stamps(self, numbers: Mapping[str, np.ndarray], rows: tuple[int, int]) -> np.ndarray:
        """Time stamps of some rows of the columns [s]."""
        return self.time.to_si(numbers[self.time.column][slice(*rows)])

    def needed(self) -> tuple[str, ...]:
        """Every column the map speaks of, once."""
        names = [*self._timing(), *(c.column for c in self.channels.values())]
        names += [c.where[0] for c in self.channels.values() if c.where]
        names += [*self.run_columns, *self.experiment_columns, *self.group_columns, *self.only]
        return tuple(n for n in dict.fromkeys(names) if not (self.by_file and n == FILE))

    def optional(self) -> frozenset[str]:
        """Columns of which not every row has to hold a number."""
        channels = self.channels.values()
        everywhere = not self.only  # else rows that nothing reads may hold anything
        return frozenset(c.column for c in channels if c.optional or c.where or not everywhere)

    def numeric(self) -> tuple[str, ...]:
        """The columns that must be numbers."""
        names = [*self._timing(), *(c.column for c in self.channels.values())]
        names += [c.where[0] for c in self.channels.values() if c.where]
        return tuple(dict.fromkeys(names))

    def _timing(self) -> tuple[str, ...]:
        """The column that tells the time; none where rows are counted."""
        return () if self.clock.every else (self.time.column,)


def read_map(file: str | Path) -> RecordingMap:
    """Read a map from TOML.

    Raises
    ------
    InvalidInput
        With every mistake of the file.
    """
    toml = read_toml(file)
    table = TableReader(toml.data, toml.problems)
    runs = table.table("runs", {})
    boundaries = tuple(runs.texts("boundaries", default=[]))
    experiments = tuple(runs.texts("experiment", default=[]))
    groups = tuple(runs.texts("group", default=[]))
    pieces = runs.integer("pieces", 1, min=1, max=100)
    begins = runs.quantity("time", "from", 0.0, min=0.0)
    after = begins if np.isfinite(begins) else 0.0
    span = after, runs.quantity("time", "until", np.inf, above=after)
    timing = table.table("time")
    clock = read_clock(timing)
    if clock.every:
        time = ChannelMap("time", COUNTED, "s", "input")
    else:
        time = read_channel(timing, "time", timing=True)
    channels = {}
    named = table.table("channels")
    for signal in named.data:
        if signal.startswith(OPEN):
            named.problem(signal, "a signal not filled in", "its name, such as position or force")
        one = named.table(signal)
        channels[signal] = read_channel(one, signal)
        _refuse_open(one, "column")
    _refuse_open(timing, "column")
    _refuse_open(runs, "boundaries", "experiment", "group")
    if clock.intervals and time.column in {c.column for c in channels.values()}:
        right = "a column of its own: its stamps take the place of the intervals"
        timing.problem("column", "the intervals are a channel as well", right)
    if "start" in table and not table.data["start"]:
        table.problem("start", "nothing in it", "position, speed or both; or no [start]")
    start = read_start(table.table("start", {}), channels, after)
    split_table = table.table("split", {})
    split = {k: tuple(split_table.texts(k, default=[])) for k in ("fit", "select", "report")}
    chosen = table.table("only", {})
    only = {column: chosen.text(column) for column in chosen.data}
    driven = table.boolean("driven", True)
    laid_out = table.table("table", {})
    layout = read_layout(laid_out)
    _refuse_open(laid_out, "columns")
    table.text("about", "")
    table.done()
    toml.problems.raise_if_any()
    return RecordingMap(
        str(file), time, channels, boundaries, experiments, groups, split, only, driven,
        layout, pieces=pieces, clock=clock, span=span, start=start,
    )  # fmt: skip


def _refuse_open(table: TableReader, *keys: str) -> None:
    """Problems of names of columns that were left open: units, signs and roles are read as such."""
    for key in keys:
        told = table.data.get(key)
        if told == OPEN or (isinstance(told, list) and OPEN in told):
            table.problem(key, "not filled in", "the name of a column")
