"""Experiments that a device with a tip and clutches can do: from these the next run is recommended.

A hand carries the tip after a moving point while commands follow a plan.  Every experiment has one
run for each clutch, along the motion in which that clutch slips: an effect may sit in one clutch
alone.  All runs last as long as recorded ones and stay within recorded poses, speeds, forces and
commands.  What no run can show (gravity by turning the base, a sensor by known weights) is told in
words by the candidates themselves.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import accumulate

import numpy as np

#: Part of the largest command at which a clutch slips while something else is looked at.
HELD = 0.5
#: Levels of "each clutch at three levels", corners of the stairs, levels of the steps.
LEVELS = (0.3, 0.9, 0.6)
CORNERS = (0.0, 0.5, 0.2, 0.9, 0.5, 0.8, 0.3, 1.0, 0.0, 0.0)
STEPS = (0.0, 0.4, 0.0, 1.0, 0.4, 1.0, 0.0, 0.2, 0.0)
#: Rests before slow ramps to breakaway, in parts of a run; the ramps share what is left of it.
RESTS = (0.03, 0.2, 0.05, 0.12)


@dataclass(frozen=True)
class TipReach:
    """How far an experimenter has gone, taken from the runs that were made.

    Parameters
    ----------
    middle, span, speed : ndarray (n,)
        Pose in the middle, how far the coordinates went to both sides, and how fast [SI].
    slip : ndarray (m, n)
        Slip of every clutch for a motion of the coordinates.
    force : float
        On the tip [N].
    commands : ndarray (m,)
        Largest of every clutch [V]; one that was never on is not used.
    duration, step : float
        Of a run and between samples [s].
    """

    middle: np.ndarray
    span: np.ndarray
    speed: np.ndarray
    slip: np.ndarray
    force: float
    commands: np.ndarray
    duration: float
    step: float

    @property
    def time(self) -> np.ndarray:
        """Instants of a planned run [s]."""
        return self.step * np.arange(round(self.duration / self.step) + 1)


@dataclass(frozen=True)
class TipPlan:
    """One planned run: pose (n, samples) to which the hand pulls, and commands (m, samples)."""

    experiment: str
    pose: np.ndarray
    commands: np.ndarray


#: Name, shape of the motion, and parts of the largest command by clutch.
Part = tuple[str, np.ndarray, dict[int, np.ndarray | float]]


def tip_experiments(reach: TipReach) -> list[TipPlan]:
    """All runs of all experiments."""
    used = [i for i in range(len(reach.slip)) if reach.commands[i] > 0.0]
    parts = [(i, part) for i in range(len(reach.slip)) for part in _free(reach)]
    for k, i in enumerate(used):
        parts += [(i, part) for part in _engaged(reach, i, used[(k + 1) % len(used)])]
    names = [name for _, (name, _, _) in parts]
    found = []
    for i, (name, shape, shares) in parts:
        commands = np.zeros((len(reach.slip), reach.time.size))
        for clutch, share in shares.items():
            commands[clutch] = reach.commands[clutch] * share
        count = names.count(name)
        told = f"{name} ({count} runs of {reach.duration:.3g} s)" if count > 1 else name
        found.append(TipPlan(told, _pose(reach, i, shape), commands))
    return found


def _free(reach: TipReach) -> list[Part]:
    """Experiments with all clutches off."""
    T, t = reach.duration, reach.time
    sweep, shaken = np.sin(2 * np.pi * t / T), np.sin(2 * np.pi * t / (T / 10))
    return [
        ("slow sweep over the range, all clutches off", sweep, {}),
        ("fast shaking on a slow sweep, all clutches off", 0.6 * sweep + 0.4 * shaken, {}),
    ]


def _engaged(reach: TipReach, i: int, other: int) -> list[Part]:
    """Experiments in which clutch `i` slips; in the last one `other` is switched in steps."""
    T, t = reach.duration, reach.time
    swing, saw = np.sin(2 * np.pi * t / (T / 4)), _saw(t, T / 3)
    stairs = np.interp(t / t[-1], np.linspace(0, 1, len(CORNERS)), CORNERS)
    found: list[Part] = [
        ("one clutch at a time at three levels, to and fro", swing, {i: _held(t, LEVELS)}),
        ("stairs of one command at a time with minor loops, to and fro", saw, {i: stairs}),
        ("steps of one command at a time from zero and from held levels, to and fro", saw,
         {i: _held(t, STEPS)}),
        ("rests and slow ramps of force to breakaway, one clutch at a time", _ramps(t), {i: HELD}),
    ]  # fmt: skip
    if other != i:
        name = "steps of one clutch at a time while another slips, to and fro"
        found.append((name, saw, {i: HELD, other: _held(t, STEPS)}))
    return found


def _pose(reach: TipReach, i: int, shape: np.ndarray) -> np.ndarray:
    """Poses along the slip of clutch `i`: as far as was gone and no faster (n, samples)."""
    way = reach.slip[i]
    moved = np.abs(way) > 1e-9 * np.abs(way).max()
    size = float(np.min(reach.span[moved] / np.abs(way[moved])))
    rate = float(np.quantile(np.abs(np.gradient(shape, reach.step)), 0.95))
    fastest = float(np.min(reach.speed[moved] / np.abs(way[moved])))
    return reach.middle[:, None] + way[:, None] * min(size, fastest / rate) * shape


def _held(t: np.ndarray, levels: Sequence[float]) -> np.ndarray:
    """Levels one after the other, of equal length."""
    at = np.minimum((t / t[-1] * len(levels)).astype(int), len(levels) - 1)
    return np.asarray(levels)[at]


def _saw(t: np.ndarray, period: float) -> np.ndarray:
    """Course to and fro at one speed, from 0."""
    return 2 / np.pi * np.arcsin(np.sin(2 * np.pi * t / period))


def _ramps(t: np.ndarray) -> np.ndarray:
    """Rests, each ended by a slow way to the other side."""
    ramp = (1.0 - sum(RESTS)) / len(RESTS)
    ends = [0.0, *accumulate(part for rest in RESTS for part in (rest, ramp))]
    sides = [0.0, *((-1.0) ** k for k in range(len(RESTS)))]
    return np.interp(t / t[-1], ends, np.repeat(sides, 2)[:-1])
