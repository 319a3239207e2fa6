"""What a controller sees: noisy, quantised, delayed positions, and speeds made from them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..controller import Controller
from ..noise import gaussian, mixed, quantised
from ..part import parameter

#: The most coordinates that are measured; `step` has 8 cells of each kind.
MOST = 8


@dataclass(frozen=True)
class Measurement(Controller):
    """Stands before other stages: they get its readings in place of true coordinates and speeds.

    Positions are noisy and quantised (potentiometers, encoders), at once or one sample late;
    speeds come from tachometers, or from differences of the readings through a first-order filter.
    The same seed gives the same bytes, whatever runs beside it.  Source: thesis 6.3 (future work:
    controllers on disturbed measurements).

    Parameters
    ----------
    noise : float
        Standard deviation of a position [rad or m].
    resolution : float
        Quantisation of a position [rad or m]; 0: none.
    late : float
        Delay of the readings of positions, and so of speeds that differ from one to the next, in
        samples, 0 or 1; a tachometer shows its speed at once.
    differenced : float
        1: speeds from differences of readings; 0: from tachometers.
    filter : float
        Time constant of the filter on differenced speeds [s].
    speed_noise : float
        Standard deviation of a tachometer [rad/s or m/s].
    seed : float
        Of the noise, a whole number.
    gain, offset : float
        Relative excess of a position, and what is added to it [rad or m].
    """

    noise: float = parameter("coordinate", 0.0, low=0.0, typical=4e-4)
    resolution: float = parameter("coordinate", 0.0, low=0.0, typical=5.75e-4)
    late: float = parameter("dimensionless", 0.0, low=0.0, high=1.0)
    differenced: float = parameter("dimensionless", 1.0, low=0.0, high=1.0)
    filter: float = parameter("time", 0.0, low=0.0)
    speed_noise: float = parameter("coordinate speed", 0.0, low=0.0)
    seed: float = parameter("dimensionless", 0.0, low=0.0, high=4e9)
    gain: float = parameter("dimensionless", 0.0, above=-1.0, typical=0.02)
    offset: float = parameter("coordinate", 0.0, typical=1e-3)

    uses: ClassVar[tuple] = (mixed, gaussian, quantised)
    #: Readings of q and qd, which later stages get; then readings kept and speeds from them, and
    #: the last instant.
    memory: ClassVar[tuple[str, ...]] = tuple(f"cell_{k}" for k in range(4 * MOST + 1))
    #: Where in its memory later stages find what they ask for by these names.
    replaces: ClassVar[dict[str, int]] = {"q": 0, "qd": MOST}
    most_coordinates: ClassVar[int] = MOST

    @staticmethod
    def step(
        k, time, q, qd, n, mem, mem_at, noise, resolution, late, differenced, filter, speed_noise,
        seed, gain, offset,
    ):  # fmt: skip
        last = mem_at + 32
        passed = time - mem[last]
        for j in range(n):
            true = (1.0 + gain) * q[j] + offset
            reading = quantised(true + noise * gaussian(seed, j, k), resolution)
            kept = mem_at + 16 + j
            before = mem[kept] if k > 0 else reading
            mem[mem_at + j] = before if late > 0.0 else reading
            if differenced > 0.0:
                rate = (reading - before) / passed if passed > 0.0 else 0.0
                share = 1.0 - math.exp(-passed / filter) if filter > 0.0 else 1.0
                made = mem_at + 24 + j
                of_before = mem[made]
                mem[made] += share * (rate - of_before)
                mem[mem_at + 8 + j] = of_before if late > 0.0 else mem[made]
            else:
                mem[mem_at + 8 + j] = qd[j] + speed_noise * gaussian(seed, 100 + j, k)
            mem[kept] = reading
        mem[last] = time
