"""What recorded channels may be wrong by, and the recording with channels times factors."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from ..units import is_unit
from .axis.joints_rig import JointSignals
from .fitting.replay import Replay
from .recordings.channel_map import ChannelMap
from .recordings.recording import Recording

#: A sign, and what a wrong prefix, per cent or decimal does.
SIGN, DECIMALS = (-1.0,), (10.0, 100.0, 1000.0)
#: What counting one edge of an encoder's four does, or two, or a radius for a diameter.
EDGES = (2.0, 4.0)
#: Units that are taken for one another, in SI ones: radians, degrees and turns; for speeds also
#: turns a minute; metres a second and kilometres an hour.
UNITS = {
    "angle": (1.0, np.pi / 180.0, 2.0 * np.pi),
    "angular_speed": (1.0, np.pi / 180.0, 2.0 * np.pi, np.pi / 30.0),
    "speed": (1.0, 1.0 / 3.6),
}
#: Factors that differ by less are one.
SAME = 1e-6
#: Channel -> what it is multiplied by.
Factors = Mapping[str, float]


def quantities(recording: Recording) -> list[tuple[str, ...]]:
    """Channels that may be wrong together: each, and all of one unit (a sensor, a logger).

    A speed goes with its position: alone it would not be the rate of that, and is refused for it.
    Constants and switches, which are 0 or 1, have no unit.
    """
    channels = recording.channels
    tied: dict[str, tuple[str, ...]] = {}
    for name, channel in channels.items():
        switch = all(set(np.unique(v).tolist()) <= {0.0, 1.0} for v in _recorded(recording, name))
        if channel.role == "constant" or switch:
            continue
        pair = (name.replace("speed", "position", 1), name.replace("position", "speed", 1))
        both = name.startswith(("position", "speed")) and all(n in channels for n in pair)
        tied[name] = pair if both else (name,)
    units = dict.fromkeys(channels[n].unit for n in tied if channels[n].unit not in ("", "1"))
    together = [
        tuple(dict.fromkeys(n for name in tied if channels[name].unit == unit for n in tied[name]))
        for unit in units
    ]
    return list(dict.fromkeys([*tied.values(), *together]))


def logged(recording: Recording, names: Sequence[str]) -> tuple[str, ...]:
    """The channels without positions that were only made by summing up a speed."""
    return tuple(n for n in names if not recording.channels[n].summed)


def factors_of_quantity(recording: Recording, names: Sequence[str]) -> list[float]:
    """Factors by which a quantity may be wrong; one that is never negative has no wrong sign."""
    both = [factor for scale in (*DECIMALS, *EDGES) for factor in (scale, 1.0 / scale)]
    signed = any((v < 0.0).any() for v in _recorded(recording, names[0]))
    units = _of_other_units(recording.channels[logged(recording, names)[0]])
    return [*(SIGN if signed else ()), *both, *units]


def _of_other_units(channel: ChannelMap) -> list[float]:
    """What a channel is to be multiplied by if it has another unit than the map says."""
    sizes = [size for dimension, size in UNITS.items() if is_unit(channel.unit, dimension)]
    factors = [size / channel.unit_scale for alike in sizes for size in alike]
    return [factor for factor in factors if abs(factor - 1.0) > SAME]


def _recorded(recording: Recording, name: str) -> list[np.ndarray]:
    found = [run.channels[name] for run in recording.runs if name in run.channels]
    return [values[np.isfinite(values)] for values in found]


def with_factors(recording: Recording, factors: Factors) -> Recording:
    """The recording with channels times their factors, and so their noise and steps."""
    runs = tuple(
        replace(r, channels={n: v * factors.get(n, 1.0) for n, v in r.channels.items()})
        for r in recording.runs
    )
    channels = dict(recording.channels)
    for name, factor in factors.items():
        c, size = channels[name], abs(factor)
        noise = None if c.noise is None else c.noise * size
        step = None if c.step is None else c.step * size
        left = None if c.left is None else c.left * size
        channels[name] = replace(c, noise=noise, step=step, left=left)
    return replace(recording, runs=runs, map=replace(recording.map, channels=channels))


def exchanges(recording: Recording) -> list[tuple[str, ...]]:
    """Channels of two joints that may be exchanged: their drives, their motions, or both.

    None of a robot, whose joints have no drives.
    """
    s, there = JointSignals(), recording.channels
    drives = f"{s.drive}_1", f"{s.drive}_2"
    if not set(drives) <= there.keys():
        return []
    pairs = ((f"{name}_1", f"{name}_2") for name in (s.position, s.speed))
    motions = tuple(n for pair in pairs if {*pair} <= there.keys() for n in pair)
    return [
        names for names in (drives, motions, (*drives, *motions))
        if all(there[a].unit == there[b].unit for a, b in zip(names[::2], names[1::2], strict=True))
    ]  # fmt: skip


def with_exchanged(recording: Recording, names: Sequence[str]) -> Recording:
    """The recording with each two channels in a row in one another's place."""
    pairs = [*zip(names[::2], names[1::2], strict=True)]
    other = {a: b for pair in pairs for a, b in (pair, pair[::-1])}
    runs = tuple(run.renamed(other) for run in recording.runs)
    channels = {
        n: replace(recording.channels[other.get(n, n)], signal=n) for n in recording.channels
    }
    return replace(recording, runs=runs, map=replace(recording.map, channels=channels))


def with_columns_exchanged(recording: Recording, one: str, other: str) -> Recording:
    """The recording with two channels each read from the other's column, in its own unit."""
    a, b = recording.channels[one], recording.channels[other]
    swapped = {one: other, other: one}
    runs = []
    for run in recording.runs:
        channels = {
            **run.channels, one: a.to_si(b.number(run.channels[other])),
            other: b.to_si(a.number(run.channels[one])),
        }  # fmt: skip
        outliers = {swapped.get(n, n): mask for n, mask in run.outliers.items()}
        runs.append(replace(run, channels=channels, outliers=outliers))
    return replace(recording, runs=tuple(runs))


def judged_like(old: Replay, new: Replay, factors: Factors) -> Replay:
    """A replay of the changed recording in which the same is compared, in the same deviations.

    And with the values of its own that the run had.
    """
    seen = {}
    for name, kept in old.observed.items():
        size = abs(factors.get(name, 1.0))
        slopes = tuple(size * slope for slope in kept.slopes)
        values = new.observed[name].values
        seen[name] = replace(kept, values=values, sd=kept.sd * size, slopes=slopes)
    return replace(new, observed=seen, own=old.own)
