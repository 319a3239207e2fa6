"""Friction laws: torque maps of clutches and of bearings, one family a file."""

from .axis_friction import CoulombViscous
from .clutch_torque import LBF_IN, LinearTorque, ModifiedQuadratic, TestbedTorque
from .table_torque import TableTorque

__all__ = [
    "LBF_IN",
    "CoulombViscous",
    "LinearTorque",
    "ModifiedQuadratic",
    "TableTorque",
    "TestbedTorque",
]
