"""Karnopp's friction model as the thesis's SimPTER used it, behind ``Scenario -> Trajectory``.

A clutch sticks while its slip speed is inside a band; there is no event location and no reduction
of order.  Nothing of the exact engine's friction code is used here: agreement means something.
"""

from .first import first_simpter
from .rules import FAIR, THESIS, TUNED, Rules
from .settings import Settings
from .simulate import GridRun, simulate

__all__ = [
    "FAIR",
    "THESIS",
    "TUNED",
    "GridRun",
    "Rules",
    "Settings",
    "first_simpter",
    "simulate",
]
