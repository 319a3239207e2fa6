"""A map to be filled in: the columns of a recording, with what its rows show and nothing else.

What a column means, its unit and its sign no row shows: a "?" stands there, which no map may keep.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence

import numpy as np

from ...problems import InvalidInput, Problem
from .layout import DATES, Layout
from .map_file import OPEN
from .seen_columns import SeenColumn, seen_columns

#: So many values are listed.
LISTED = 6
#: Where the notes behind a key begin.
NOTES = 34


def draft_map(source: str) -> str:
    """A map of a recording, to be filled in.

    Parameters
    ----------
    source : str
        File of a recording.

    Returns
    -------
    str
        TOML; what only its maker can know is ``"?"``.

    Raises
    ------
    InvalidInput
        If the file cannot be read, or holds no column of numbers.
    """
    layout, columns = seen_columns(source)
    if not any(c.numbers is not None and not c.dates for c in columns):
        got = ", ".join(c.name for c in columns) or "no columns"
        right = "a table with columns of numbers"
        raise InvalidInput([Problem(source, "", "no column of numbers is seen", got, right)])
    times = [c for c in columns if c.tells_time()]
    time = times[0] if len(times) == 1 else None
    runs = [c for c in columns if c.tells_runs() and c not in times]
    told = [
        c for c in columns
        if c is time or c.numbers is None or c.dates or (c in runs and _new(c, time))
    ]  # fmt: skip
    rows = max((len(c.texts) for c in columns), default=0)
    lines = [
        f"# A map of {source} ({rows} rows), to be filled in: write what is right for every",
        f'# "{OPEN}", and leave out channels that are not needed.  Behind # stands what the rows',
        "# show; they show no unit, no sign and no meaning.",
        *_table(layout),
        *_time(times),
        *_runs(runs, time),
        "# Signals: position, speed, force, torque, current, drive, duty, supply, reference,",
        "# command, pressure, temperature, or another name for what friction may depend on.",
    ]
    kept = [c for c in columns if not any(c is other for other in told)]
    for k, column in enumerate(kept, 1):
        lines += ["", f'[channels."{OPEN} {k}"]', *_channel(column, first=k == 1)]
    return "\n".join(lines) + "\n"


def _table(layout: Layout) -> list[str]:
    keys = {
        "names": layout.names or None,
        "rows": layout.rows or None,
        "decimal": layout.decimal if layout.decimal != "." else None,
        "columns": list(layout.columns) or None,
    }
    said = [f"{k} = {_toml(v)}" for k, v in keys.items() if v is not None]
    if layout.columns:
        unnamed = all(name == f"c{k}" for k, name in enumerate(layout.columns, 1))
        why = "no line names them" if unnamed else "c1, c2 ... where their line names several alike"
        said[-1] = _noted(said[-1], f"{why}: give them names")
    return ["", "[table]", *said] if said else []


def _time(times: Sequence[SeenColumn]) -> list[str]:
    if not times:
        note = "no column rises throughout: the time between rows, or [time] column = ..."
        return ["", "[time]", _noted(f'every = "{OPEN}"', note)]
    one = times[0]
    if len(times) > 1:
        note = "these rise throughout: " + ", ".join(c.name for c in times)
        column = _noted(f'column = "{OPEN}"', note)
    else:
        column = _noted(f"column = {_toml(one.name)}", f"{_range(one)}{_steps(one)}")
    unit = f'unit = "{DATES if len(times) == 1 and one.dates else OPEN}"'
    return ["", "[time]", column, unit]


def _steps(time: SeenColumn) -> str:
    """How far stamps are apart, and how often they begin anew."""
    if time.numbers is None:
        return ""
    steps, begins = np.diff(time.numbers), len(time.begins())
    again = f", begins anew {_times(begins)}" if begins else ""
    unit = " s" if time.dates else ""
    return f", mostly in steps of {np.median(steps[steps > 0.0]):.4g}{unit}{again}"


def _new(column: SeenColumn, time: SeenColumn | None) -> bool:
    """Whether a column changes wherever the time begins anew, and nowhere else."""
    return time is not None and bool(time.begins()) and column.changes() == time.begins()


def _runs(runs: Sequence[SeenColumn], time: SeenColumn | None) -> list[str]:
    if not runs:
        begins = len(time.begins()) if time is not None else 0
        note = "# every file is one run: no column tells runs apart"
        more = f", but {_times(begins)} the time begins anew: save each run as a file"
        return ["", note + more * bool(begins), ""]
    seen = [
        f"#   {c.name}: {_listed(c)}; changes {_times(len(c.changes()))}"
        + ", wherever the time begins anew" * _new(c, time)
        for c in runs
    ]
    return [
        "",
        "[runs]",
        _noted(f'boundaries = ["{OPEN}"]', "columns; a run ends where one of them changes"),
        _noted(f'group = ["{OPEN}"]', "columns; runs are split by this into fitted, held out ..."),
        "# Columns with few values, some of which may tell runs apart:",
        *seen,
        "",
    ]


def _channel(column: SeenColumn, first: bool) -> list[str]:
    sign, role = f'sign = "{OPEN}"', f'role = "{OPEN}"'
    if first:
        sign = _noted(sign, "1, or -1 where it counts the other way than the model")
        role = _noted(role, '"measured", "input" or "constant"')
    return [
        _noted(f"column = {_toml(column.name)}", _range(column)),
        f'unit = "{OPEN}"',
        sign,
        role,
    ]


def _range(column: SeenColumn) -> str:
    """What the rows show of a column."""
    if column.numbers is None or column.dates:
        return f"{column.texts[0]} to {column.texts[-1]}"
    finite = column.numbers[np.isfinite(column.numbers)]
    if not finite.size:
        return "no numbers"
    lacking = column.numbers.size - finite.size
    less = f", no number in {lacking} rows" if lacking else ""
    if finite.min() == finite.max():
        return f"always {finite[0]:.6g}{less}"
    few = len(column.distinct()) <= LISTED
    return (_listed(column) if few else f"{finite.min():.6g} to {finite.max():.6g}") + less


def _listed(column: SeenColumn) -> str:
    values = column.distinct()
    more = f" ... ({len(values)} values)" if len(values) > LISTED else ""
    return ", ".join(values[:LISTED]) + more


def _times(count: int) -> str:
    return "once" if count == 1 else f"{count} times"


def _noted(key: str, note: str) -> str:
    return f"{key:<{NOTES}} # {note}"


def _toml(value: int | str | Iterable[str]) -> str:
    """As TOML has it (its strings are those of JSON)."""
    return json.dumps(value, ensure_ascii=False)
