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
        ``effective_excitation(excitation, ...)``, ``seen_command(command, ...)``,
        ``excitation_rate(rate, excitation, command, ...)``: each receives the value so far and
        returns the new one. ``bristle_torque(level, breakaway, ...)``: torque against positive slip
        in place of stiction; such a clutch never sticks (its mode stays FORWARD).
    On a coordinate (``coordinate`` >= 0 is its index):
        ``force(speed, position, time, ...)`` a generalized force to be added,
        ``inertia(position, ...)`` an inertia to be added on the diagonal (constant in time).
    States:
        every name in ``states`` has a ``<name>_rate(...)``; states start at 0, those in ``settled``
        at the clutch's excitation, of a coordinate at its speed, when a run begins.
    Guards:
        every name in ``guards`` has a ``<name>_guard(...)``, positive while nothing happens, and a
        ``<name>_jump(t, y, p, held, dmode, states_at, modes_at)`` that changes states and discrete
        modes (``modes`` counts them) when it falls through zero.
    Numbers:
        Methods ``changed_delay(delay)``, ``changed_threshold(threshold)`` replace the clutch's.

    Signals: ``time, slip, speed, direction, excitation, effective, command, angle`` (clutch), for
    torques ``applied, conservative`` (loads' and potential forces along the slip) and, of a single
    coordinate with a single clutch, ``net, mass`` (all forces but friction, and inertia); in
    rates also ``torque``, ``rate`` (of the excitation), ``engaged`` (1 or 0), with a
    ``bristle_torque`` ``level, breakaway``; in guards ``rate, slip, level, breakaway``;
    ``position, speed`` (coordinate), ``coordinate`` (its index); parameters, states, and
    ``held_<name>`` by name.
    """

    states: ClassVar[tuple[str, ...]] = ()
    settled: ClassVar[tuple[str, ...]] = ()
    guards: ClassVar[tuple[str, ...]] = ()
    modes: ClassVar[int] = 0
    #: The experiment that reveals it, in one line.
    reveals: ClassVar[str] = ""
    #: What is looked for together: effects of one family are forms of one another.
    family: ClassVar[str] = ""
    #: Where: "friction", "actuator" (of a clutch or an axis), "load" or "breakaway".
    acts_on: ClassVar[str] = ""
    #: Coordinates along which its lack shows (as verdicts name them, "slip_velocity"); () if any.
    shows_along: ClassVar[tuple[str, ...]] = ()
    #: Parameters that measure how much of it there is: where all are 0 the effect does nothing.
    sizes: ClassVar[tuple[str, ...]] = ()
    #: Ports whose value so far it does not use: such an effect has to be the first there.
    replaces: ClassVar[tuple[str, ...]] = ()

    clutch: int = -1
    coordinate: int = -1

    def follows(self) -> str:
        """Logged channel of a recording whose course its ``points`` are; "" if it has none."""
        return ""

    def changed_delay(self, delay: float) -> float:
        """Off-to-on delay of the clutch it acts on [s], given that without it."""
        return delay

    def changed_threshold(self, threshold: float) -> float:
        """Off threshold of the clutch it acts on [V], given that without it."""
        return threshold
