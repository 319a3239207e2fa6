"""Behind the scatter and the counts: what each rule, rate and band does to one and the same run."""

from __future__ import annotations

import functools
from collections import Counter
from dataclasses import dataclass, replace

import numpy as np

from ..karnopp import FAIR, THESIS
from ..karnopp import simulate as karnopp
from ..laws import LBF_IN
from ..measuring.metrics import saturation_time
from ..measuring.transitions import transitions
from ..rigs.inputs import Inputs, drawn, nominal
from ..rigs.line import line
from ..trajectory import Trajectory
from .rows import Engine, Row, claim
from .sampled_loop import border
from .standard import Brief, brief

#: Bands of the Karnopp runs [rad/s]; the thesis does not print its own.
BANDS = (1e-2, 1e-3, 1e-4, 1e-5)
#: Rules of Karnopp runs by name (``karnopp.rules``).
RULES = {
    "thesis": THESIS,
    "thesis with another limiter": replace(THESIS, limiter=FAIR.limiter),
    "fair": FAIR,
}
#: Rates of the controller that are compared [Hz].
RATES = (150.0, 1000.0)
#: A command alternates where it goes up and down by at least so much from sample to sample [V].
ALTERNATES = 0.5


@functools.lru_cache(maxsize=64)
def banded(rules: str, band: float, rtol: float = 1e-3) -> Engine:
    """Karnopp's model with a band as an engine; compiled where llvmlite is there."""

    def engine(scenario) -> Trajectory:
        own = {"rules": RULES[rules], "rtol": rtol, "atol": 1e-3 * rtol}
        return karnopp(scenario, band, compiled=_compiles(), **own)

    return engine


@functools.lru_cache(maxsize=1)
def _compiles() -> bool:
    try:
        import llvmlite  # noqa: F401
    except ImportError:
        return False
    return True


@functools.lru_cache(maxsize=256)
def counted(rules: str, band: float, rtol: float, gain: float) -> Brief:
    """The standard run with a band, measured."""
    return brief(banded(rules, band, rtol)(line(gain=gain)), nominal().line_y)


@functools.lru_cache(maxsize=8)
def exactly(engine: Engine, gain: float) -> Brief:
    """The exact standard run, measured."""
    return brief(engine(line(gain=gain)), nominal().line_y)


def over_rates(engine: Engine) -> Counter[int]:
    """Transitions without feedback with the controller at 140 to 160 Hz, in steps of 0.5 Hz."""
    x = nominal()
    rates = [x.replace(rate=140.0 + 0.5 * k) for k in range(41)]
    runs = (engine(line(inputs=own)) for own in rates)
    return Counter(transitions(run).total for run in runs)


def just_caught(engine: Engine) -> tuple[float, float, list[float]]:
    """The first stop of clutch 3 without feedback [s]; 20 ms later its slip velocity [rad/s] and
    the torques asked of the clutches [lb-in]."""
    run = engine(line(gain=0.0))
    t = next(e.t for e in run.events if e.kind == "slip stop" and e.clutches == (3,))
    y, held = run.state(t + 0.02), run.held[run.segment_at(t + 0.02)]
    m = len(run.scenario.clutches)
    return t, float(y[2] - y[3]), [float(v) / LBF_IN for v in held[m : 2 * m]]


@functools.lru_cache(maxsize=4)
def over_inputs(engine: Engine, draws: int) -> list[tuple[int, int]]:
    """Transitions without feedback and with 0.16, for plausible inputs."""

    def count(inputs: Inputs, gain: float) -> int:
        return transitions(engine(line(gain=gain, inputs=inputs))).total

    return [(count(inputs, 0.0), count(inputs, 0.16)) for inputs in drawn(draws, seed=35)]


@dataclass(frozen=True)
class Pace:
    """The standard run at a gain and a rate of the controller.

    ``jerk`` in in/s^3, ``saturated`` and ``alternating`` shares of the time and of the samples (of
    the clutch with the most).
    """

    jerk: float
    saturated: float
    alternating: float


@functools.lru_cache(maxsize=256)
def pace(engine: Engine, gain: float, rate: float) -> Pace:
    """Run it."""
    x = nominal().replace(rate=rate)
    found = engine(line(gain=gain, inputs=x))
    share = max(saturation_time(found)) / found.t_end
    return Pace(brief(found, x.line_y).average_jerk, share, alternating(found, 1.0 / rate))


def alternating(found: Trajectory, period: float) -> float:
    """Share of samples at which some command turns from up to down or back, by 0.5 V at least."""
    starts = np.arange(int(found.t_end / period)) * period
    at = np.searchsorted(found.segment_t[:, 0], starts + 1e-9, side="right") - 1
    steps = np.diff(found.held[at, : len(found.scenario.clutches)], axis=0)
    turned = (steps[1:] * steps[:-1] < 0.0) & (
        np.minimum(abs(steps[1:]), abs(steps[:-1])) >= ALTERNATES
    )
    return float(turned.any(axis=1).mean())


def causes(engine: Engine) -> list[Row]:
    """Why jerk rises with the gain, and which rule makes the thesis's simulator count otherwise."""
    top = {rate: pace(engine, 0.6, rate) for rate in RATES}
    low = {rate: pace(engine, 0.2, rate) for rate in RATES}
    text = "; ".join(
        f"{r:g} Hz: jerk {low[r].jerk:.0f} in/s^3 at 0.2 and {top[r].jerk:.0f} at 0.6, commands "
        f"alternate at {100 * low[r].alternating:.0f} and {100 * top[r].alternating:.0f} % of the "
        f"samples, are at full scale for {100 * low[r].saturated:.1f} and "
        f"{100 * top[r].saturated:.1f} % of the time"
        for r in RATES
    )
    borders = [border(RATES[0], wanted=w) for w in (100.0, 200.0)]
    gain, band = 0.0, BANDS[-1]
    exact = exactly(engine, gain)
    runs = {name: counted(name, band, 1e-6, gain) for name in RULES}
    return [
        claim(
            "A38",
            "jerk rises at high gain because the commands saturate",
            "ascribed to saturation",
            text,
            top[1000.0].jerk > 1.5 * low[1000.0].jerk,
            why="with faster samples the rise is gone: it is the sampled torque loop beyond its "
            f"border of stability (at 150 Hz a gain of {borders[0]:.2f} at 100 lb-in and of "
            f"{borders[1]:.2f} at 200 lb-in), and what there is of saturation follows from it",
        ),
        claim(
            "A35 S7 S54",
            "with a band of 1e-5 rad/s the simulator of the thesis finds the exact run",
            "not said",
            f"exact: {exact.transitions} in {exact.run_time:.2f} s, error "
            f"{exact.average_error:.3f} in; "
            + "; ".join(
                f"{n}: {b.transitions} in {b.run_time:.2f} s, error {b.average_error:.3f} in"
                for n, b in runs.items()
            ),
            abs(runs["thesis"].average_error / exact.average_error - 1.0) < 0.02,
            why="with the limiter of 3.2.4 the slip of a clutch that was caught in the band never "
            "is zero, and the torque translator, which goes by its sign, goes on asking that "
            "clutch; with a limiter that takes the slip out the run tends to the exact one. That "
            "a clutch at rest is not asked is how the translator is read here; the thesis prints "
            "no rule",
        ),
    ]
