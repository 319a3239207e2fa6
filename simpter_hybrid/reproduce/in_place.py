"""4.2: why tests on the assembled robot gave time constants of 0.24 to 2.4 s."""

from __future__ import annotations

import functools
import math

import numpy as np

from ..laws import LBF_IN
from ..measuring.sampling import sample
from ..rigs.in_place import breakaway as breakaway_rig
from ..rigs.in_place import moving, sine_points
from ..trajectory import Trajectory
from .rows import Engine, Row, claim

#: How quickly the hand corrects the link's speed [rad/s]: slow to about as quick as a hand can be.
CROSSOVERS = (0.7, 1.0, 1.5, 2.0, 2.5)
VOLTS = (2.5, 4.0, 5.5)
STEP_AT = 4.0


@functools.lru_cache(maxsize=64)
def stepped(engine: Engine, crossover: float, volts: float) -> Trajectory:
    """A step of clutch 1 while a hand turns link A."""
    points = ((0.0, 0.0), (STEP_AT, 0.0), (STEP_AT, volts))
    return engine(moving(points, crossover, 13.0))


def from_tip_force(trajectory: Trajectory, times: np.ndarray) -> np.ndarray:
    """Torque of clutch 1 as Gomes had it: the hand's tip force turned into a torque of link A."""
    return sample(trajectory, times).load[:, 0] / LBF_IN


def apparent(times: np.ndarray, torque: np.ndarray) -> float:
    """Time from the start of a response to 63.2 % of its final change [s]."""
    final = float(torque[-100:].mean())
    change = (torque - torque[0]) / (final - torque[0])
    start = times[np.argmax(change > 0.05)]
    reach = times[np.argmax(change > 1.0 - math.exp(-1.0))]
    return float(reach - start)


def in_place(engine: Engine) -> list[Row]:
    """Steps, frequency responses and breakaway on the assembled robot."""
    times = STEP_AT + np.arange(int(8.9 / 0.005)) * 0.005
    true, seen = {}, {}
    for crossover in CROSSOVERS:
        for volts in VOLTS:
            run = stepped(engine, crossover, volts)
            seen[crossover, volts] = apparent(times, from_tip_force(run, times))
            if run.mode[-1, 0] != 0:
                actual = np.abs(sample(run, times).tau[:, 0]) / LBF_IN
                true[crossover, volts] = apparent(times, actual)
    low, high = min(seen.values()), max(seen.values())
    stopped = [
        key for key in seen if any(e.kind == "slip stop" for e in stepped(engine, *key).events)
    ]
    bands = frequency_response(engine)
    return [
        claim(
            "A14 S36",
            "step tests on the robot show time constants of 0.24 to 2.4 s",
            "0.24-2.4 s (4.2: 0.25-2.5 s)",
            f"{low:.2f} to {high:.2f} s for hands that correct the speed at {CROSSOVERS[0]:g} to "
            f"{CROSSOVERS[-1]:g} rad/s, with a clutch whose torque needs "
            f"{min(true.values()):.2f} to {max(true.values()):.2f} s",
            low < 0.5 and high > 2.0 and max(true.values()) < low,
            why="the torque was computed from the tip force as if the link did not accelerate: "
            "it is "
            "the hand's force, which follows as slowly as the hand corrects the speed of a heavy "
            "link; the clutch is hidden behind it",
            low=low,
            high=high,
        ),
        claim(
            "A14 S36",
            "the long constants belong to links that the clutch stops",
            "not said",
            f"the link stops in {len(stopped)} of {len(seen)} runs; there the hand pushes up from "
            f"rest: {np.mean([seen[k] for k in stopped] or [np.nan]):.2f} s on average against "
            f"{np.mean([v for k, v in seen.items() if k not in stopped]):.2f} s",
            bool(stopped)
            and np.mean([seen[k] for k in stopped])
            > np.mean([v for k, v in seen.items() if k not in stopped]),
        ),
        *bands,
        breakaway(engine),
    ]


def frequency_response(engine: Engine) -> list[Row]:
    """The biased sinusoid at single frequencies: apparent first-order constants."""
    found = {}
    for crossover in (1.0, 2.0):
        ratios = []
        for f in (0.1, 0.2, 0.4, 0.8):
            run = engine(moving(sine_points(4.0, 1.5, f, 14.0), crossover, 14.0))
            cycles = max(int(6.0 * f), 1)
            times = run.t_end - 0.01 - np.arange(int(cycles / f / 0.01)) * 0.01
            torque = from_tip_force(run, times)
            squared = (4.0 + 1.5 * np.sin(2.0 * np.pi * f * times)) ** 2 * 6.439 * 0.9409
            wave = np.exp(-2j * np.pi * f * times)
            ratio = (wave @ (torque - torque.mean())) / (wave @ (squared - squared.mean()))
            ratios.append((f, abs(ratio)))
        gains = np.array([g for _, g in ratios])
        freqs = np.array([f for f, _ in ratios])
        lags = np.sqrt(np.maximum(1.0 / gains**2 - 1.0, 0.0)) / (2.0 * np.pi * freqs)
        found[crossover] = (float(np.median(lags)), gains)
    text = "; ".join(
        f"hand at {c:g} rad/s: {lag:.2f} s (gain {', '.join(f'{g:.2f}' for g in gains)} at 0.1, "
        "0.2, "
        "0.4, 0.8 Hz)"
        for c, (lag, gains) in found.items()
    )
    seen = [lag for lag, _ in found.values()]
    return [
        claim(
            "A14 S36",
            "frequency responses differ widely from the step responses",
            "widely differing",
            text,
            max(seen) > 2.0 * min(seen) or min(seen) > 0.24,
            why="single frequencies stand for the sweep; the gain is that of hand and link",
        ),
    ]


def breakaway(engine: Engine) -> Row:
    """S35: breakaway by a tip force in several directions."""
    right = (6.648 * 4.0 + 6.176) * 4.0 + 5.253
    errors = {}
    for degrees in (60, 90, 120, 150, 180):
        run = engine(breakaway_rig(4.0, math.radians(degrees), 4.0))
        slips = [e.t for e in run.events if e.kind == "breakaway"]
        if slips:
            seen = float(from_tip_force(run, np.array([slips[0]]))[0])
            errors[degrees] = abs(seen) / right - 1.0
    text = ", ".join(f"{d} deg {100 * e:+.1f} %" for d, e in errors.items())
    worst = max(abs(e) for e in errors.values())
    return claim(
        "S35",
        "breakaway of one clutch from the tip force at the onset of slip",
        "done so by Gomes",
        f"against (43) at 4 V, by direction of the force: {text}",
        worst < 0.1,
        why="link B is free and swings away under the same force; its inertia and the coupling "
        "terms "
        "load the stuck clutch as well",
        worst=worst,
    )
