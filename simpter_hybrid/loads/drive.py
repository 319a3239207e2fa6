"""Motors: what a held voltage does to an axis."""

from __future__ import annotations

from dataclasses import dataclass

from ..applied_load import Load
from ..part import index, parameter


@dataclass(frozen=True)
class VoltageDrive(Load):
    """A motor driven by voltage: ``force = kt/R V - kt^2/R speed`` on its coordinate.

    The voltage is the held input of its axis (``controllers.axis_servo``); a released drive gives
    no torque at all.

    Parameters
    ----------
    constant : float
        Force for each ampere, after the gear [N m/A or N/A].
    resistance : float
        [ohm].
    coordinate : float
        Number of the coordinate, from 0.
    """

    constant: float = parameter("force an ampere", above=0.0)
    resistance: float = parameter("resistance", above=0.0)
    coordinate: float = index("coordinate", 0.0)

    @staticmethod
    def force(qd, held, at_drive_1, at_open_1, Q, constant, resistance, coordinate):
        j = int(coordinate)
        if held[at_open_1 + j] == 0.0:
            current = (held[at_drive_1 + j] - constant * qd[j]) / resistance
            Q[j] += constant * current


@dataclass(frozen=True)
class ForceDrive(Load):
    """A motor with current control: a force in proportion to the held input of its axis.

    Parameters
    ----------
    constant : float
        Force for each volt [N m/V or N/V].
    coordinate : float
        Number of the coordinate, from 0.
    """

    constant: float = parameter("force a volt")
    coordinate: float = index("coordinate", 0.0)

    @staticmethod
    def force(held, at_drive_1, at_open_1, Q, constant, coordinate):
        j = int(coordinate)
        if held[at_open_1 + j] == 0.0:
            Q[j] += constant * held[at_drive_1 + j]


@dataclass(frozen=True)
class CurrentDrive(ForceDrive):
    """A motor of known current, as a drive shows it: a force in proportion to the held input.

    Parameters
    ----------
    constant : float
        Force for each ampere, after the gear [N m/A or N/A].
    coordinate : float
        Number of the coordinate, from 0.
    """

    constant: float = parameter("force an ampere")
