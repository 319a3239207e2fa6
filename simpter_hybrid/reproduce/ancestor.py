"""2.3: the first simulation of the robot, whose clutches deliver what is asked of them."""

from __future__ import annotations

import numpy as np

from ..known_units import INCH
from ..laws import LBF_IN
from ..measuring.energy import energy_balance
from ..measuring.metrics import measures
from ..measuring.sampling import sample
from ..rigs.circle import CAPACITY, circle
from .rows import Engine, Row, claim


def ancestor(engine: Engine) -> list[Row]:
    """Ideal against real clutches behind the same controller on the same circle."""
    ideal, real = engine(circle(True)), engine(circle(False))
    grid = np.arange(int(ideal.t_end / 2e-3)) * 2e-3
    found = sample(ideal, grid)
    wanted = np.column_stack([found.held[f"desired_{i + 1}"] for i in range(4)])
    slipping = np.abs(found.mode) == 1
    delivered = np.abs(found.tau)
    off = float(np.abs(delivered - np.minimum(wanted, CAPACITY))[slipping].max()) / LBF_IN
    power = energy_balance(ideal).max_clutch_power
    errors = [measures(t, 2e-3) for t in (ideal, real)]
    first, second = (m.average_error / INCH for m in errors)
    return [
        claim(
            "S5",
            "an ideal clutch delivers what is asked, up to its capacity",
            "first check",
            f"largest difference while slipping {off:.2g} lb-in",
            off < 1e-6,
        ),
        claim(
            "S5",
            "and never adds energy",
            "second check",
            f"largest clutch power {power:.2g} W",
            power <= 1e-12,
        ),
        claim(
            "S5",
            "it predicts the true behaviour of the device poorly",
            "performed poorly",
            f"average error {first:.3f} in with ideal clutches, {second:.3f} in with those of "
            f"chapter 5; {errors[0].transitions} and {errors[1].transitions} transitions",
            second > 2.0 * first,
            why="the circle and the forces are not printed",
        ),
    ]
