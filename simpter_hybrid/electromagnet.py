"""The clutch as an electromagnet: normal force and torque from the coil's current."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from .clutch import TorqueLaw
from .part import parameter


@dataclass(frozen=True)
class ElectromagnetTorque(TorqueLaw):
    """Torque of a friction clutch pressed by its own coil, thesis equations (31)-(35).

    The stored energy ``L i^2/2`` gives the normal force ``N = (1/2) |dL/dx| i^2`` by virtual work
    at constant current, Coulomb friction ``F = mu N``, and the mean radius the torque: quadratic in
    the current, without linear or constant part.

    Parameters
    ----------
    amperes : float
        Current per volt of excitation [A/V].
    inductance_slope : float
        Size of dL/dx at the closed gap [H/m].
    radius : float
        Mean radius of the friction surface [m].
    sliding, static : float
        Coefficients of friction; ``static >= sliding``.
    """

    amperes: float = parameter("current/voltage", above=0.0)
    inductance_slope: float = parameter("inductance/length", above=0.0)
    radius: float = parameter("length", above=0.0)
    sliding: float = parameter("dimensionless", low=0.0)
    static: float = parameter("dimensionless", low=0.0)

    scaled: ClassVar[tuple[str, ...]] = ("sliding", "static")
    breaking: ClassVar[tuple[str, ...]] = ("static",)

    @staticmethod
    def slip_torque(excitation, amperes, inductance_slope, radius, sliding):
        current = amperes * excitation
        return sliding * radius * 0.5 * inductance_slope * current * current

    @staticmethod
    def break_torque(excitation, amperes, inductance_slope, radius, static):
        current = amperes * excitation
        return static * radius * 0.5 * inductance_slope * current * current
