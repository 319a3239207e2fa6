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
    coasting : float
        1 for a driver that gives pulses and opens the motor's ends between them: its back-EMF acts
        during pulses alone.  0 for one that shorts them, so that it always does.
    supply : float
        Height of such pulses [V]: what is told over it is their part of the time.  0: no pulses.
    coordinate : float
        Number of the coordinate, from 0.
    """

    constant: float = parameter("force an ampere", above=0.0)
    resistance: float = parameter("resistance", above=0.0)
    coasting: float = parameter("dimensionless", 0.0, low=0.0, high=1.0)
    supply: float = parameter("voltage", 0.0, low=0.0)
    coordinate: float = index("coordinate", 0.0)

    @staticmethod
    def force(
        qd, held, at_drive_1, at_open_1, Q, constant, resistance, coasting, supply, coordinate
    ):
        j = int(coordinate)
        if held[at_open_1 + j] == 0.0:
            told = held[at_drive_1 + j]
            closed = 1.0
            if supply > 0.0:
                closed = 1.0 - coasting * (1.0 - min(abs(told) / supply, 1.0))
            Q[j] += constant * (told - closed * constant * qd[j]) / resistance


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
