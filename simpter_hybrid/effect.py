"""An effect: something a model lacks, added at one port."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from .part import Part


@dataclass(frozen=True)
class Effect(Part):
    """Base of effects; a subclass defines static functions named after the ports it changes.

    On a clutch (``clutch`` >= 0 is its index):
        ``slip_torque(torque, speed, direction, ...)``, ``break_torque(torque, direction, ...)``,
        ``effective_excitation(excitation, ...)``, ``excitation_rate(rate, excitation, command, ...)``,
        ``seen_command(command, ...)``: each receives the value so far and returns the new one.
    On a coordinate (``coordinate`` >= 0 is its index):
        ``force(speed, position, time, ...)`` a generalized force to be added,
        ``inertia(position, ...)`` an inertia to be added on the diagonal (constant in time).
    States:
        every name in ``states`` has a ``<name>_rate(...)``; states start at 0.
    Guards:
        every name in ``guards`` has a ``<name>_guard(...)``, positive while nothing happens, and a
        ``<name>_jump(t, y, p, held, dmode, states_at, modes_at)`` that changes states and discrete
        modes (``modes`` counts them) when it falls through zero.

    Signals: ``time, slip, speed, direction, excitation, effective, command, angle, torque`` (clutch);
    ``position, speed`` (coordinate); parameters, states, and ``held_<name>`` by name.
    """

    states: ClassVar[tuple[str, ...]] = ()
    guards: ClassVar[tuple[str, ...]] = ()
    modes: ClassVar[int] = 0

    clutch: int = -1
    coordinate: int = -1
