"""The first SimPTER (thesis 4.2): the controller's own table, inverted, as the clutch."""

from __future__ import annotations

from dataclasses import replace

from ..controllers.lookup import LookupTable
from ..laws import LinearTorque
from ..scenario import Scenario

#: Time constants within the range that Gomes had measured [s]: 0.24 to 2.4 (3.2.3.1).
TIME_CONSTANTS = (0.24, 0.5, 1.0, 2.4)


def first_simpter(
    scenario: Scenario, time_constant: float = TIME_CONSTANTS[0], ratio: float = 1.0
) -> Scenario:
    """The scenario with the clutches of the first SimPTER.

    Parameters
    ----------
    scenario : Scenario
        One whose controllers include a ``LookupTable``.
    time_constant : float
        First-order lag [s]; the thesis used several in Gomes's range, without a switch-on delay.
    ratio : float
        Breakaway torque over slip torque. Gomes's breakaway model is not printed; 1 by default.

    Returns
    -------
    Scenario
        For either engine. The torque model is the inverse of the table, so that a clutch gives in
        the end what was asked of it.

    Raises
    ------
    ValueError
        If no controller is a ``LookupTable``, or a number is out of range.
    """
    if not (time_constant > 0.0 and ratio >= 1.0):
        raise ValueError(
            f"time_constant = {time_constant!r} s must be above 0 s, ratio = {ratio!r} at least 1"
        )
    tables = [c for c, _ in scenario.controllers if isinstance(c, LookupTable)]
    if not tables:
        raise ValueError(
            f"scenario {scenario.name!r} has no look-up table to invert; "
            "the first SimPTER's clutches are defined by one (for example line-y24)"
        )
    law = LinearTorque(tables[0].torque, tables[0].full_scale, ratio)
    clutches = tuple(
        replace(clutch, torque=law, time_constant=time_constant, delay=0.0)
        for clutch in scenario.clutches
    )
    return scenario.replace(name=f"{scenario.name}-first-simpter", clutches=clutches)
