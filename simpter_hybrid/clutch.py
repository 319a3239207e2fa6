"""A clutch: excitation dynamics and torque map of one controlled friction surface."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import ClassVar

from .part import Part, parameter


@dataclass(frozen=True)
class TorqueLaw(Part):
    """Base of torque maps: static ``slip_torque(speed, excitation, ...)`` and
    ``break_torque(excitation, ...)`` in N m, both non-negative, and
    ``break_torque >= slip_torque(0+)``.

    Each asks by name for what it uses: ``speed``, the size of the slip speed [rad/s], and
    ``excitation`` [V], its parameters, and ``p`` with ``table_at`` (where its table begins there).
    Surfaces that rub along lengths have N and m/s in place of N m and rad/s.

    ``scaled`` are its numbers to which dry friction, sliding and breaking, is proportional,
    ``breaking`` those to which breakaway alone is: a diagnosis asks whether all are off by a share.
    ``multiplied`` are those of which one in ``scaled`` is a factor.
    """

    scaled: ClassVar[tuple[str, ...]] = ()
    breaking: ClassVar[tuple[str, ...]] = ()
    multiplied: ClassVar[tuple[str, ...]] = ()
    of_surfaces: ClassVar[bool] = True


@dataclass(frozen=True)
class Clutch(Part):
    """One clutch.

    Parameters
    ----------
    torque : TorqueLaw
        Torque map.
    time_constant : float
        First-order lag from the held command to the excitation [s]; 0 follows the command at once.
    delay : float
        From off to on only: time from the command to the first excitation [s]. The delay must pass
        uninterrupted; a command that drops meanwhile starts it anew.
    threshold : float
        The clutch goes off when its command is at or below this and its excitation has fallen to it
        [V]; excitation and torque are then 0 and the gap is open. Negative: always engaged.
    full_scale : float
        Largest command [V].
    """

    torque: TorqueLaw = field(default_factory=TorqueLaw)
    time_constant: float = parameter("time", 0.07, low=0.0)
    delay: float = parameter("time", 0.02, low=0.0)
    threshold: float = parameter("voltage", 0.05)
    full_scale: float = parameter("voltage", 10.0, above=0.0)
