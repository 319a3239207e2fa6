"""The motorised clutch testbed: one rotor, one clutch, and its torque sensor if it is to give."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..device import Device
from ..part import parameter


@dataclass(frozen=True)
class Testbed(Device):
    """One rotor braked against ground (thesis Figure 13); also the torque bar and a single link.

    Parameters
    ----------
    inertia : float
        Of everything that turns with the motor [kg m^2].
    """

    inertia: float = parameter("inertia", above=0.0)

    coordinates: ClassVar[tuple[str, ...]] = ("rotor",)
    surfaces: ClassVar[tuple[str, ...]] = ("clutch 1",)
    __test__: ClassVar[bool] = False

    @staticmethod
    def mass_matrix(q, p, out):
        out[0] = p[0]

    @staticmethod
    def velocity_terms(q, qd, p, out):
        out[0] = 0.0

    @staticmethod
    def clutch_map(q, p, out):
        out[0] = 1.0

    @staticmethod
    def clutch_map_rate(q, qd, p, out):
        out[0] = 0.0


@dataclass(frozen=True)
class SensorTestbed(Device):
    """The testbed with its coil on the torque sensor's spring (thesis equations (40)-(42)).

    The clutch acts between rotor and coil; the sensor reads ``stiffness`` times the coil's angle.

    Parameters
    ----------
    inertia : float
        Of everything that turns with the motor [kg m^2].
    coil : float
        Inertia of the coil on the sensor [kg m^2].
    stiffness : float
        Of the sensor [N m/rad].
    damping : float
        Of the sensor [N m s/rad].
    """

    inertia: float = parameter("inertia", above=0.0)
    coil: float = parameter("inertia", above=0.0)
    stiffness: float = parameter("rotational_stiffness", low=0.0)
    damping: float = parameter("rotational_damping", low=0.0)

    coordinates: ClassVar[tuple[str, ...]] = ("rotor", "coil")
    surfaces: ClassVar[tuple[str, ...]] = ("clutch 1",)

    @staticmethod
    def mass_matrix(q, p, out):
        out[0] = p[0]
        out[1] = 0.0
        out[2] = 0.0
        out[3] = p[1]

    @staticmethod
    def velocity_terms(q, qd, p, out):
        out[0] = 0.0
        out[1] = 0.0

    @staticmethod
    def damping_force(q, qd, p, out):
        out[0] = 0.0
        out[1] = -p[3] * qd[1]

    @staticmethod
    def clutch_map(q, p, out):
        out[0] = 1.0
        out[1] = -1.0

    @staticmethod
    def clutch_map_rate(q, qd, p, out):
        out[0] = 0.0

    @staticmethod
    def conservative_force(q, p, out):
        out[0] = 0.0
        out[1] = -p[2] * q[1]

    @staticmethod
    def potential_energy(q, p):
        return 0.5 * p[2] * q[1] * q[1]
