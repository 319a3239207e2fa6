"""Settings of a Karnopp run: band, solver and rules."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from ..scenario import Scenario
from .records import Options
from .rules import CLOSEST, LIMITERS, TUNED, Rules

SOLVERS = ("variable", "fixed")
#: What a bound without end counts up to.
MOST = 2**62


@dataclass(frozen=True)
class Settings:
    """How to run Karnopp's model.

    Parameters
    ----------
    band : float
        Half width of the band of slip speeds in which a clutch sticks [rad/s or m/s].
    solver : str
        ``variable``: Dormand-Prince 4(5) with ode45's step control (SIMULINK's defaults are rtol
        1e-3, atol 1e-6). ``fixed``: the same formula without error control (ode5).
    step : float, optional
        Step of the fixed solver [s]; by default ``band`` / (20 rad/s^2), between 1e-6 s and 2 ms:
        no clutch then crosses the band within a step while it decelerates at less than that.
    rules : Rules
    rtol, atol : float
        Tolerances of the variable solver; well below the band, or it chatters.
    max_step : float, optional
        Longest step of the variable solver [s]; by default a fiftieth of the run, as in SIMULINK.
    max_steps : int
        After so many steps, rejected ones included, the run fails: a clutch chatters on the edge
        of the band.
    compiled : bool
        Run the same source as machine code.

    Raises
    ------
    ValueError
        For settings that make no sense.
    """

    band: float = 1e-3
    solver: str = "variable"
    step: float | None = None
    rules: Rules = field(default_factory=lambda: TUNED)
    rtol: float = 1e-6
    atol: float = 1e-9
    max_step: float | None = None
    max_steps: int = 1_000_000
    compiled: bool = False

    def __post_init__(self) -> None:
        if self.solver not in SOLVERS:
            raise ValueError(
                f"solver = {self.solver!r} is unknown; choose one of {', '.join(SOLVERS)}"
            )
        for name, unit in (
            ("band", " rad/s"), ("step", " s"), ("rtol", ""), ("atol", ""), ("max_step", " s")
        ):  # fmt: skip
            value = getattr(self, name)
            if value is not None and not (math.isfinite(value) and value > 0.0):
                raise ValueError(f"{name} = {value!r}{unit} must be a positive, finite number")
        if not self.max_steps >= 1:
            raise ValueError(f"max_steps = {self.max_steps!r} must be at least 1")

    @property
    def fixed_step(self) -> float:
        """Step of the fixed solver [s]."""
        return self.step or min(max(self.band / 20.0, 1e-6), 2e-3)

    def options(self, scenario: Scenario, record: bool = True) -> Options:
        """The settings as the numbers that the flat functions read.

        Parameters
        ----------
        scenario : Scenario
        record : bool
            Whether steps are kept.
        """
        z = scenario.sizes()
        rules = self.rules
        # Tables 1 and 2 are PTER's: its case numbers tell that a device has them.
        table = rules.cases == "table" and scenario.device.case_of((2,) * z["m"]) == "1"
        return Options(
            band=self.band, limiter=LIMITERS.index(rules.limiter), both=int(rules.signs == "both"),
            resolve=int(rules.saturated == "resolve"), relative=CLOSEST.index(rules.closest),
            table=int(table), variable=int(self.solver == "variable"), step=self.fixed_step,
            rtol=self.rtol, atol=self.atol, max_step=self.max_step or scenario.t_end / 50.0,
            min_step=1e-12 * scenario.t_end, t_end=scenario.t_end, period=scenario.period,
            span=2 * z["n"] + z["m"] + z["nz"], stops=len(scenario.stops), record=int(record),
            nh=z["nh"], nd=z["nd"], limit=int(min(self.max_steps, MOST)),
            nbreaks=len(scenario.breakpoints()),
        )  # fmt: skip
