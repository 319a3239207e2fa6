"""Figures 43 and 44: error and jerk over the torque feedback gain, and the scatter above 0.2."""

from __future__ import annotations

import functools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..known_units import INCH
from ..measuring.metrics import saturation_time
from ..measuring.variation import total_variation
from ..rigs.inputs import Inputs, drawn, nominal
from ..rigs.line import line
from .rows import Engine, Row, claim
from .standard import Brief, brief

#: Gains of the sweep [V/(lb-in)]; the thesis's figures run from 0 to 0.6.
GAINS = tuple(round(0.02 * k, 2) for k in range(31))


@dataclass(frozen=True)
class Point:
    """One run of the sweep; variation of acceleration in in/s^3, saturation as a share of time."""

    gain: float
    brief: Brief
    variation: float
    saturated: float


def point(engine: Engine, gain: float, inputs: Inputs, whole: bool = True) -> Point:
    """One gain; without its variation of acceleration (nan) unless ``whole``."""
    trajectory = engine(line(gain=gain, inputs=inputs))
    share = max(saturation_time(trajectory)) / trajectory.t_end
    rate = float("nan")
    if whole:
        found = total_variation(trajectory)
        rate = (found.rate_smooth + found.rate_jumps) / INCH
    return Point(gain, brief(trajectory, inputs.line_y), rate, share)


@functools.lru_cache(maxsize=4)
def swept(engine: Engine, whole: bool = True) -> list[Point]:
    """The sweep at the nominal inputs."""
    return [point(engine, g, nominal(), whole) for g in GAINS]


def scatter(values: np.ndarray) -> float:
    """Root mean square of second differences, relative to the mean: 0 for a straight line.

    A smooth curve sampled at even steps has small ones; "seemingly random" has large ones.
    """
    second = values[2:] - 2.0 * values[1:-1] + values[:-2]
    return float(np.sqrt(np.mean(second**2)) / np.mean(values))


@dataclass(frozen=True)
class Curves:
    """The sweep as arrays over the gain: error [in], jerk and variation [in/s^3], saturation."""

    gains: np.ndarray
    error: np.ndarray
    jerk: np.ndarray
    variation: np.ndarray
    saturated: np.ndarray


def curves(points: Sequence[Point]) -> Curves:
    """What a figure shows of a sweep."""
    return Curves(
        gains=np.array([p.gain for p in points]),
        error=np.array([p.brief.average_error for p in points]),
        jerk=np.array([p.brief.average_jerk for p in points]),
        variation=np.array([p.variation for p in points]),
        saturated=np.array([p.saturated for p in points]),
    )


def gain_sweep(engine: Engine, draws: int = 16) -> list[Row]:
    """What 5.4.2 reads off its Figures 43 and 44."""
    over = curves(swept(engine))
    shares = falling_share(engine, draws)
    return [*falling(over, shares, draws), *erratic(over), *trade_off(over)]


def falling(over: Curves, shares: tuple[float, float], draws: int) -> list[Row]:
    """Up to a gain of 0.2; with shares of the plausible inputs, as of `falling_share`."""
    error, jerk, variation = over.error, over.jerk, over.variation
    return [
        claim(
            "A38",
            "error falls with the gain up to about 0.2",
            "0.36 to 0.13 in",
            f"{error[0]:.3f} in at 0, {error[8]:.3f} at 0.16, {error[10]:.3f} at 0.2; both below "
            f"0.6 times that at 0 for {100 * shares[0]:.0f} % of {draws} plausible inputs",
            lower(error[[0, 8, 10]].tolist(), 0.6),
            share=shares[0],
        ),
        claim(
            "A38",
            "jerk falls with the gain up to about 0.2",
            "456 to 317 in/s^3",
            f"{jerk[0]:.0f} in/s^3 at 0, {jerk[8]:.0f} at 0.16, {jerk[10]:.0f} at 0.2 (5 ms "
            f"differences); variation {variation[0]:.0f}, {variation[8]:.0f}, {variation[10]:.0f}; "
            f"both below that at 0 for {100 * shares[1]:.0f} % of {draws} plausible inputs",
            lower(jerk[[0, 8, 10]].tolist(), 1.0),
            share=shares[1],
        ),
    ]


def erratic(over: Curves) -> list[Row]:
    """Above a gain of 0.2: scatter, and commands at full scale."""
    error, jerk, saturated = over.error, over.jerk, over.saturated
    low, high = over.gains <= 0.2, over.gains >= 0.2
    return [
        claim(
            "A38",
            "above it both vary in a seemingly random fashion",
            "erratic above 0.2",
            f"scatter of error {scatter(error[low]):.2f} below and "
            f"{scatter(error[high]):.2f} above 0.2, of jerk "
            f"{scatter(jerk[low]):.2f} and {scatter(jerk[high]):.2f}",
            scatter(jerk[high]) > 1.5 * scatter(jerk[low])
            and scatter(error[high]) > 1.5 * scatter(error[low]),
        ),
        claim(
            "A38",
            "because over 0.2 the commands saturate significantly",
            "significant levels above 0.2",
            f"share of time at full scale (clutch with the most): {100 * saturated[5]:.1f} % at "
            "0.1, "
            f"{100 * saturated[10]:.1f} % at 0.2, {100 * saturated[20]:.1f} % at 0.4, "
            f"{100 * saturated[30]:.1f} % at 0.6",
            saturated[high].mean() > 3.0 * saturated[low].mean() and saturated[high].mean() > 0.05,
        ),
    ]


def trade_off(over: Curves) -> list[Row]:
    """The gain of 0.16 that the thesis chooses."""
    error, jerk, gains = over.error, over.jerk, over.gains
    best = float(gains[int(np.argmin(jerk))])
    return [
        claim(
            "A38",
            "average jerk rises considerably above 0.16",
            "rises",
            f"mean jerk {jerk[(gains > 0.2)].mean():.0f} in/s^3 above 0.2, {jerk[8]:.0f} at 0.16",
            jerk[gains > 0.2].mean() > 1.2 * jerk[8],
        ),
        claim(
            "A38",
            "0.16 is a good trade-off of error and smoothness",
            "0.16",
            f"least jerk at {best:g} ({jerk.min():.0f} in/s^3, error "
            f"{error[int(np.argmin(jerk))]:.3f} in); at 0.16 {jerk[8]:.0f} and {error[8]:.3f}",
            jerk[8] < 1.25 * jerk.min() or abs(best - 0.16) < 0.05,
        ),
    ]


def lower(values: Sequence[float], most: float) -> bool:
    """Whether all values but the first are less than ``most`` times that."""
    return all(v < most * values[0] for v in values[1:])


def falling_share(engine: Engine, draws: int) -> tuple[float, float]:
    """Shares of the plausible inputs for which error and jerk fall as they are claimed to."""
    error, jerk = [], []
    for inputs in drawn(draws, seed=43):
        runs = [point(engine, g, inputs, False).brief for g in (0.0, 0.16, 0.2)]
        error.append(lower([r.average_error for r in runs], 0.6))
        jerk.append(lower([r.average_jerk for r in runs], 1.0))
    return float(np.mean(error)), float(np.mean(jerk))
