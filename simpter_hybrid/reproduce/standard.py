"""The three runs of Tables 5 and 6, nominal and over the plausible inputs, each computed once."""

from __future__ import annotations

import functools
from dataclasses import dataclass

import numpy as np

from ..known_units import INCH
from ..measuring.metrics import (
    Metrics,
    differences,
    measures,
    path_weighted_average,
    time_weighted_average,
)
from ..measuring.sampling import sample
from ..measuring.transitions import transitions
from ..rigs.inputs import drawn
from ..rigs.line import line
from ..scenario import Scenario
from ..trajectory import Trajectory
from .rows import Engine

#: Torque selector and feedback gain [V/(lb-in)] of Table 6's three controllers.
CONTROLLERS = {
    "baseline": ("impedance", 0.0),
    "P": ("impedance", 0.16),
    "velocity": ("velocity", 0.16),
}

#: Sampling step of the measures of plausible runs [s]; coarser than the nominal ones' 1 ms.
COARSE = 0.005


@functools.lru_cache(maxsize=512)
def run_of(scenario_key: tuple, engine: Engine) -> Trajectory:
    """A standard run by (torque selector, gain, options of ``line`` as sorted pairs)."""
    kind, gain, options = scenario_key
    return engine(line(kind, gain, **dict(options)))


def run(engine: Engine, kind: str = "impedance", gain: float = 0.0, **options) -> Trajectory:
    """A standard run, kept."""
    return run_of((kind, gain, tuple(sorted(options.items()))), engine)


def standard(engine: Engine, name: str) -> Trajectory:
    """One of Table 6's three runs, by its name in ``CONTROLLERS``."""
    return run(engine, *CONTROLLERS[name])


@functools.lru_cache(maxsize=8)
def table(engine: Engine) -> dict[str, Metrics]:
    """Measures of Table 6's three runs at 1 ms."""
    return {name: measures(standard(engine, name)) for name in CONTROLLERS}


@dataclass(frozen=True)
class Brief:
    """A run's measures in the thesis's units (in, s), on the coarse step."""

    finished: bool
    run_time: float
    average_error: float
    max_error: float
    average_jerk: float
    path_length: float
    average_acceleration: float
    max_acceleration: float
    flat_portions: tuple[int, ...]

    @property
    def transitions(self) -> int:
        """Flat portions of all clutches."""
        return sum(self.flat_portions)


def brief(trajectory: Trajectory, line_y: float) -> Brief:
    """Measure a run quickly."""
    grid = np.arange(int(trajectory.t_end / COARSE) + 1) * COARSE
    found = sample(trajectory, grid)
    error = np.abs(found.tip[:, 1] - line_y)
    average, length = path_weighted_average(found.tip, error)
    size = np.linalg.norm(found.tip_acceleration, axis=1)
    jerk = differences(found.t, found.tip_acceleration)
    return Brief(
        finished=trajectory.status == "stopped",
        run_time=trajectory.t_end,
        average_error=average / INCH,
        max_error=float(error.max()) / INCH,
        average_jerk=time_weighted_average(found.t, jerk) / INCH,
        path_length=length / INCH,
        average_acceleration=time_weighted_average(found.t, size) / INCH,
        max_acceleration=float(size.max()) / INCH,
        flat_portions=transitions(trajectory).counts,
    )


def reached(scenario: Scenario, engine: Engine, line_y: float) -> Brief:
    """Run and measure; a run that does not reach the stop line says so in ``finished``."""
    return brief(engine(scenario), line_y)


@functools.lru_cache(maxsize=8)
def plausible(engine: Engine, draws: int) -> list[dict[str, Brief]]:
    """Table 6's three runs for every set of drawn inputs."""
    found = []
    for inputs in drawn(draws):
        short = inputs.replace()
        found.append(
            {
                name: reached(line(kind, gain, short), engine, short.line_y)
                for name, (kind, gain) in CONTROLLERS.items()
            }
        )
    return found
