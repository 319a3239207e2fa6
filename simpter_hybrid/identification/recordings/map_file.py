"""The map of a recording: which column is which signal, in which unit and with which sign.

Nothing is guessed: a column without unit and sign in the map is not read.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TypeVar

import numpy as np

from ...files.tomlfile import read_toml
from ...problems import MISSING
from ...reading.reader import TableReader
from .clock import COUNTED, Clock, read_clock
from .filtering import Filter
from .layout import DATES, Layout, read_layout
from .map_units import PLAIN, check_plain, check_time, conversion, si_difference, si_values

Number = TypeVar("Number", float, np.ndarray)

ROLES = ("input", "measured", "constant")
#: How a channel goes on between its rows: `ChannelMap.held`.
HELD = ("sampled", "before", "after")
#: Column that every file has: its own name, unless one is called so.
FILE = "file"
#: Part of the way between a sensor's limits that counts as none.
ROUNDING = 1e-9


@dataclass(frozen=True)
class ChannelMap:
    """One channel.

    Parameters
    ----------
    signal, column, unit : str
    role : str
        ``input`` drives the replay, ``measured`` is compared, ``constant`` holds for a run.
    scale, shift : float
        SI value = sign * (scale * number + shift).
    times : float
        Numbers of the column times this are in `unit`: of counts, steps of a converter.
    sign : int
    clock_shift : float
        Added to the stamps of this channel [s].
    noise, step : float or None
        Standard deviation before values were rounded, and quantisation, where known [SI].
    limits : tuple of float or None
        Where the sensor saturates, as numbers of the column: before sign and offset.
    held : str
        ``before`` if a row's value held over the interval that ends at its stamp, ``after`` if
        from then on, ``sampled`` if the channel is continuous.
    where : tuple or None
        (column, value): the channel applies only in rows in which that column has that value.
    filter : Filter or None
    may_rest : bool
        Whether the quantity may stand still (a position), so that one value says nothing.
    optional : bool
        Whether a file without this column, or with nothing in it, is still a recording.
    summed : bool
        Whether no column has it: it was made of another channel.
    left : float or None
        Noise after a filter or a clock shift, which make it smaller and no longer white [SI].
    adds_to : str
        Parameter of the declared model that a run's constant is added to; "" if it is none.
    wraps : float
        The column begins anew after so much [SI]: a turn; 0 if it does not.
    """

    signal: str
    column: str
    unit: str
    role: str
    scale: float = 1.0
    shift: float = 0.0
    sign: int = 1
    clock_shift: float = 0.0
    noise: float | None = None
    step: float | None = None
    limits: tuple[float, float] | None = None
    held: str = "sampled"
    where: tuple[str, float] | None = None
    filter: Filter | None = None
    may_rest: bool = False
    optional: bool = False
    summed: bool = False
    left: float | None = None
    times: float = 1.0
    adds_to: str = ""
    wraps: float = 0.0

    @property
    def unit_scale(self) -> float:
        """SI value of one `unit`."""
        return self.scale / self.times

    def to_si(self, numbers: np.ndarray) -> np.ndarray:
        """Numbers of the file in SI units."""
        return self.sign * (self.scale * numbers + self.shift)

    def written(self, value: float) -> str:
        """An SI value in the channel's unit, before sign and offset."""
        return self._in_unit(self.number(value) * self.times)

    def number(self, value: Number) -> Number:
        """An SI value as the column has it."""
        return (self.sign * value - self.shift) / self.scale

    def written_change(self, value: float) -> str:
        """A difference of SI values in the channel's unit, before the sign."""
        return self._in_unit(self.sign * value / self.unit_scale)

    def within(self, numbers: np.ndarray | float) -> np.ndarray:
        """Which numbers of the column lie within the sensor's limits, not at them."""
        low, high = self.limits or (-np.inf, np.inf)
        # A limit is read in SI units and back: rounding is no distance from it.
        apart = ROUNDING * (high - low) if self.limits else 0.0
        numbers = np.asarray(numbers)
        return (numbers > low + apart) & (numbers < high - apart)

    def _in_unit(self, number: float) -> str:
        return f"{number:.6g} {'' if self.unit in PLAIN else self.unit}".rstrip()


@dataclass(frozen=True)
class RecordingMap:
    """A whole map; `split` says which groups fit, select and report.

    `only`: column -> text; runs in whose first row the column reads otherwise are left out.
    `driven`: False of an axis that is let alone.  `layout`: of a table of text.
    `by_file`: a file's name stands for the column `FILE`, which it lacks.  `pieces`: into so many
    runs, each a group, every run is cut.  `clock`: how time is told, where not by stamps.
    `span`: from when to when rows of a run count, from its first one [s].
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
    span = begins, runs.quantity("time", "until", np.inf, above=begins)
    timing = table.table("time")
    clock = read_clock(timing)
    if clock.every:
        time = ChannelMap("time", COUNTED, "s", "input")
    else:
        time = _channel(timing, "time", timing=True)
    channels = {}
    named = table.table("channels")
    for signal in named.data:
        channels[signal] = _channel(named.table(signal), signal)
    if clock.intervals and time.column in {c.column for c in channels.values()}:
        right = "a column of its own: its stamps take the place of the intervals"
        timing.problem("column", "the intervals are a channel as well", right)
    split_table = table.table("split", {})
    split = {k: tuple(split_table.texts(k, default=[])) for k in ("fit", "select", "report")}
    chosen = table.table("only", {})
    only = {column: chosen.text(column) for column in chosen.data}
    driven = table.boolean("driven", True)
    layout = read_layout(table.table("table", {}))
    table.text("about", "")
    table.done()
    toml.problems.raise_if_any()
    return RecordingMap(
        str(file), time, channels, boundaries, experiments, groups, split, only, driven,
        layout, pieces=pieces, clock=clock, span=span,
    )  # fmt: skip


def _channel(table: TableReader, signal: str, timing: bool = False) -> ChannelMap:
    column, unit = table.text("column"), table.text("unit")
    if timing and unit == DATES:
        return ChannelMap(signal, column, unit, "input")
    times = table.number("times", 1.0, above=0.0)
    scale, shift = conversion(table, unit)
    scale *= times
    if timing:
        check_time(table, unit)
        return ChannelMap(signal, column, unit, "input", scale, shift, times=times)
    if "unit" in table:
        check_plain(table, signal, unit)
    role = table.choice("role", ROLES)
    sign = table.integer("sign", min=-1, max=1)
    if sign == 0:
        table.problem("sign", "neither sign", "1 or -1")
    offset = si_difference(table, "offset", unit, 0.0)
    if "limits" in table and "wraps" in table:
        right = "one of both: what begins anew has no limit"
        table.problem("limits", "a sensor that ends and begins anew", right)
    limits = tuple((v - shift) / scale for v in si_values(table, "limits", unit)) or None
    return ChannelMap(
        signal, column, unit, role, scale, shift + offset, sign,
        table.quantity("time", "clock_shift", 0.0),
        si_difference(table, "noise", unit, None),
        si_difference(table, "step", unit, None),
        limits,  # type: ignore[arg-type]
        table.choice("held", HELD, "sampled"),
        _where(table),
        _filter(table),
        table.boolean("may_rest", False),
        table.boolean("optional", False),
        times=times,
        adds_to=table.text("adds_to", ""),
        wraps=abs(si_difference(table, "wraps", unit, 0.0)),
    )  # fmt: skip


def _where(table: TableReader) -> tuple[str, float] | None:
    if "where" not in table:
        table.raw("where", None)
        return None
    inner = table.table("where")
    return inner.text("column"), inner.number("equals")


def _filter(table: TableReader) -> Filter | None:
    if "filter" not in table:
        table.raw("filter", MISSING)
        return None
    inner = table.table("filter")
    inner.choice("kind", ("butterworth",))
    return Filter(inner.integer("order", min=1, max=8), inner.quantity("frequency", "cutoff"))
