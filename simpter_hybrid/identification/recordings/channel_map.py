"""One channel of a recording's map: a column, its unit and sign, what is known of its sensor."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeVar

import numpy as np

from ...problems import MISSING
from ...reading.reader import TableReader
from .filtering import Filter
from .layout import DATES
from .map_units import PLAIN, check_plain, check_time, conversion, si_difference, si_values

Number = TypeVar("Number", float, np.ndarray)

ROLES = ("input", "measured", "constant")
#: How a channel goes on between its rows: `ChannelMap.held`.
HELD = ("sampled", "before", "after")
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
    held_stated : bool
        Whether the map says so itself.
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
    held_stated: bool = False
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

    @property
    def suffix(self) -> str:
        """The unit behind a number; nothing, where numbers are plain."""
        return "" if self.unit in PLAIN else f" {self.unit}"

    def in_unit(self, value: Number) -> Number:
        """An SI value in the channel's unit, before sign and offset."""
        return self.number(value) * self.times

    def written(self, value: float) -> str:
        """`in_unit`, with the unit."""
        return f"{self.in_unit(value):.6g}{self.suffix}"

    def number(self, value: Number) -> Number:
        """An SI value as the column has it."""
        return (self.sign * value - self.shift) / self.scale

    def written_change(self, value: float) -> str:
        """A difference of SI values in the channel's unit, before the sign."""
        return self.written_size(self.sign * value)

    def written_size(self, value: float) -> str:
        """A size [SI] in the channel's unit."""
        return f"{value / self.unit_scale:.6g}{self.suffix}"

    def within(self, numbers: np.ndarray | float) -> np.ndarray:
        """Which numbers of the column lie within the sensor's limits, not at them."""
        low, high = self.limits or (-np.inf, np.inf)
        # A limit is read in SI units and back: rounding is no distance from it.
        apart = ROUNDING * (high - low) if self.limits else 0.0
        numbers = np.asarray(numbers)
        return (numbers > low + apart) & (numbers < high - apart)


def read_channel(table: TableReader, signal: str, timing: bool = False) -> ChannelMap:
    """A channel as its table of a map has it; `timing`: that of the time."""
    column = table.text("column", right="the name of a column in quotes")
    unit = table.text("unit", right='the unit that the logger had, in quotes, e.g. "N" or "1"')
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
        "held" in table,
        _where(table),
        _filter(table),
        table.boolean("may_rest", False),
        table.boolean("optional", False),
        times=times,
        adds_to=table.text("adds_to", ""),
        wraps=_turn(table, unit),
    )  # fmt: skip


def _turn(table: TableReader, unit: str) -> float:
    """What a column begins anew after [SI]; 0 for one that goes on."""
    if "wraps" not in table:
        return float(si_difference(table, "wraps", unit, 0.0))
    turn = float(si_difference(table, "wraps", unit, 1.0))
    if turn <= 0.0:
        table.problem("wraps", "not above zero", f'what it begins anew after, e.g. "360 {unit}"')
    return turn


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
