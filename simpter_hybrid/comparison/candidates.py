"""What is compared: a name, the number that is to tend to zero, and a way to run a scenario."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

from ..karnopp import FAIR, THESIS, TUNED, Settings
from ..scenario import Scenario
from ..trajectory import Trajectory

#: SIMULINK's default tolerances of ode45.
SIMULINK = {"rtol": 1e-3, "atol": 1e-6}

#: Longest step [s] of ``fair`` and ``tuned`` rules: with SIMULINK's, a fiftieth of the run, a step
#: from a locked state jumps over a short overload.
LONGEST = 5e-3

#: A Karnopp run that takes more steps than this chatters.
STEPS = 200_000


@dataclass(frozen=True)
class Candidate:
    """One way to run a scenario.

    Parameters
    ----------
    name : str
    family : str
        What it is a member of: candidates of one family are one line in a picture.
    size : float
        Band, width or step [rad/s or s] that is to tend to zero.
    run : callable
        ``run(scenario) -> Trajectory``.
    """

    name: str
    family: str
    size: float
    run: Callable[[Scenario], Trajectory]


def karnopp(
    band: float,
    rules: str = "tuned",
    solver: str = "variable",
    step: float | None = None,
    rtol: float | None = None,
    compiled: bool = False,
) -> Candidate:
    """Karnopp's model with a band [rad/s].

    ``rules`` are ``thesis`` (as described there), ``fair`` (its tables, every choice for the
    better) or ``tuned`` (without the tables); see ``karnopp.Rules``. Unless ``rtol`` is given the
    tolerance is SIMULINK's for ``thesis``, else a thousandth of the band within 1e-11 and 1e-6,
    with steps of 5 ms at most.
    """
    from ..karnopp import simulate

    chosen = {"thesis": THESIS, "fair": FAIR, "tuned": TUNED}[rules]
    fine = rtol if rtol is not None else min(max(1e-3 * band, 1e-11), 1e-6)
    tolerances = {"rtol": fine, "atol": 1e-3 * fine}
    if rules == "thesis" and rtol is None:
        tolerances = SIMULINK
    settings: dict[str, Any] = {"solver": solver, "step": step, "rules": chosen, "max_steps": STEPS}
    settings |= {"compiled": compiled} | tolerances
    if rules != "thesis":
        settings["max_step"] = LONGEST
    if solver == "fixed":
        settings["max_steps"] = 1_000_000_000  # as many as the step makes; the record ends first
    Settings(band, **settings)  # refuses wrong settings now rather than in the middle
    word = "" if solver == "variable" else ", fixed step" + (f" {step:g} s" if step else "")
    return Candidate(
        f"Karnopp ({rules}{word}), band {band:g}", f"Karnopp ({rules}{word})", band,
        partial(simulate, band=band, **settings),
    )  # fmt: skip


def regularised(width: float, solver: str = "LSODA", rtol: float = 1e-7) -> Candidate:
    """Friction made smooth over a ``width`` [rad/s], with a stiff solver."""
    from ..regularised import simulate

    return Candidate(
        f"tanh ({solver}), width {width:g}", f"tanh ({solver})", width,
        partial(simulate, width=width, solver=solver, rtol=rtol, atol=1e-3 * rtol),
    )  # fmt: skip
