"""Friction of a bearing, a gear or a seal: what is always there, whatever is commanded."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..clutch import TorqueLaw
from ..part import parameter


@dataclass(frozen=True)
class CoulombViscous(TorqueLaw):
    """Friction ``coulomb + normal u + viscous speed``; at rest ``1 + stiction`` times that holds.

    The excitation u stands for whatever presses the surfaces together (a seal's pressure, one volt
    for each unit of it).  A joint's friction is a clutch with this map that is always engaged:
    ``threshold`` below 0 V, ``time_constant`` and ``delay`` 0.

    Parameters
    ----------
    coulomb : float
        [N m or N].
    viscous : float
        [N m s/rad or N s/m].
    stiction : float
        Relative excess of breakaway.
    normal : float
        Friction a volt of excitation [N m/V or N/V].
    """

    coulomb: float = parameter("coordinate force", low=0.0)
    viscous: float = parameter("coordinate damping", 0.0, low=0.0)
    stiction: float = parameter("dimensionless", 0.0, low=0.0)
    normal: float = parameter("force a volt", 0.0)

    scaled: ClassVar[tuple[str, ...]] = ("coulomb", "normal")

    @staticmethod
    def slip_torque(speed, excitation, coulomb, viscous, normal):
        return coulomb + normal * excitation + viscous * speed

    @staticmethod
    def break_torque(excitation, coulomb, stiction, normal):
        return (1.0 + stiction) * (coulomb + normal * excitation)
