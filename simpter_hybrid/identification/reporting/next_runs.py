"""The runs to make next in numbers: what an experimenter lays down, in the units of the record."""

from __future__ import annotations

import csv
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from io import StringIO

import numpy as np

from ..axis.signals import AxisSignals
from ..fitting.replay import Replay
from ..identifiability_report import Sight
from ..recordings.channel_map import ChannelMap
from ..recordings.map_units import PLAIN
from ..recordings.recording import Recording
from ..recordings.row_step import row_step

#: Part of a course that is no faster than the speed that is told of it: a step has none.
MOSTLY = 0.95
#: A release is told by so few samples.
BEGINS = 2


@dataclass(frozen=True)
class NextRun:
    """One experiment that could be made next.

    Parameters
    ----------
    experiment : str
    words : str
        How long it lasts, and from where to where each channel goes, in the units of the record.
    runs : tuple of (str, ndarray (samples,), mapping of str to ndarray (samples,))
        Name, time stamps [s] and what is laid down, column -> numbers; none of a release.
    """

    experiment: str
    words: str
    runs: tuple[tuple[str, np.ndarray, Mapping[str, np.ndarray]], ...]


def next_runs(sight: Sight | None, recording: Recording) -> dict[str, NextRun]:
    """Experiments that were planned, by name."""
    if sight is None:
        return {}
    by_name: dict[str, list[Replay]] = {}
    for run in sight.planned:
        by_name.setdefault(run.experiment, []).append(run)
    return {name: _told(name, runs, recording) for name, runs in by_name.items()}


def next_runs_csv(runs: Sequence[NextRun]) -> str:
    """All that is laid down in these experiments, a row for each sample; "" if nothing is.

    A column that one experiment has and another has not is empty there.
    """
    parts = [(one.experiment, *run) for one in runs for run in one.runs]
    columns = list(dict.fromkeys(c for *_, laid in parts for c in laid))
    if not columns:
        return ""
    made = StringIO()
    writer = csv.writer(made, lineterminator="\n")
    writer.writerow(("experiment", "run", "t [s]", *columns))
    for experiment, name, time, laid in parts:
        cells = [[f"{x:.9g}" for x in laid[c].tolist()] if c in laid else [""] * time.size
                 for c in columns]  # fmt: skip
        stamps = [f"{t:.9g}" for t in time.tolist()]
        rows = zip(stamps, *cells, strict=True)
        writer.writerows((experiment, name, *row) for row in rows)
    return made.getvalue()


def _told(name: str, runs: Sequence[Replay], recording: Recording) -> NextRun:
    duration = max(float(r.time[-1] - r.time[0]) for r in runs)
    ways = ", ".join(_ways(runs, recording.channels))
    each = f"{len(runs)} runs of {duration:.3g} s" if len(runs) > 1 else f"{duration:.3g} s"
    laid = tuple(
        (r.name, _stamps(r), written)
        for r in runs
        if (written := _written(r, recording.channels)) and not _released(r)
    )
    lasts = [] if each in name else [each]  # some experiments have it in their name
    words = ": ".join(filter(None, [*lasts, ways]))
    return NextRun(name, words + _either(runs[0].laid_down), laid)


def _either(laid_down: Mapping[str, np.ndarray]) -> str:
    """Who is told what, of a drive beside the motion that it makes; "" of all else."""
    s = AxisSignals()
    drives = [n for n in s.drive if n in laid_down]
    moves = [n for n in (s.position, s.speed) if n in laid_down]
    if not (drives and moves):
        return ""
    return f" (a driver is told the {drives[0]}, a servo the {moves[0]})"


def _stamps(run: Replay) -> np.ndarray:
    """Of the samples that are laid down, also where a replay leaves some at its ends out [s]."""
    size = max(x.size for x in run.laid_down.values())
    return run.time if size == run.time.size else np.linspace(run.time[0], run.time[-1], size)


def _released(run: Replay) -> bool:
    return any(x.size == BEGINS for x in run.laid_down.values())


def _written(run: Replay, channels: Mapping[str, ChannelMap]) -> dict[str, np.ndarray]:
    """Columns in the units of the record, with its signs and offsets."""
    return {
        _named(n, channels[n]): _number(channels[n], x)
        for n, x in run.laid_down.items()
        if n in channels
    }


def _number(channel: ChannelMap, values: np.ndarray) -> np.ndarray:
    """In the unit, with the sign and the offset of the record; 0 has no sign."""
    return channel.in_unit(values) + 0.0


def _named(signal: str, channel: ChannelMap) -> str:
    """A signal with its column in the record, which may be called otherwise, and its unit."""
    unit = "" if channel.unit in PLAIN else f" [{channel.unit}]"
    return f"{signal}{unit}" if channel.column == signal else f"{signal} ({channel.column}){unit}"


def _digits(number: float) -> str:
    """Three digits, as a person writes them: 7,140 and not 7.14e+03."""
    short = f"{number:.3g}"
    return f"{float(short):,.0f}" if 1e3 <= abs(float(short)) < 1e6 else short


def _ways(runs: Sequence[Replay], channels: Mapping[str, ChannelMap]) -> Iterator[str]:
    """From where to where each channel goes over all runs; what stays at nothing is not told."""
    for name in runs[0].laid_down:
        if name not in channels:
            continue
        channel, told = channels[name], name.replace("_", " ")
        every = [r.laid_down[name] for r in runs]
        unit = channel.suffix
        ends = [float(f([f(_number(channel, x)) for x in every])) for f in (np.min, np.max)]
        fast = max(_fast(r, name) for r in runs) / abs(channel.unit_scale)
        if every[0].size == BEGINS:
            begin = _number(channel, every[0])[0]
            way = fast * np.sign(channel.sign * (every[0][-1] - every[0][0])) + 0.0
            with_it = f" with {_digits(way)}{unit}/s" if _travels(name) else ""
            yield f"let go at {told} {_digits(begin)}{unit}{with_it}"
        elif _digits(ends[0]) != _digits(ends[1]):
            speed = f" at up to {_digits(fast)}{unit}/s" if fast > 0.0 and _travels(name) else ""
            yield f"{told} {_digits(ends[0])} to {_digits(ends[1])}{unit}{speed}"
        elif any(float(np.abs(x).max()) > 0.0 for x in every):
            yield f"{told} {_digits(ends[0])}{unit}"


def _travels(name: str) -> bool:
    """Whether it is a position: what else changes is told by its ends."""
    return name.startswith("position") or name == "reference"


def _fast(run: Replay, name: str) -> float:
    """How fast a course mostly goes [SI/s]."""
    course = run.laid_down[name]
    steps = np.diff(course) / row_step(run.time)
    return float(np.quantile(np.abs(steps), MOSTLY)) if steps.size else 0.0
