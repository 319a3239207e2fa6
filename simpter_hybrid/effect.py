"""An effect: something a model lacks, added at one port."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from .part import Part


@dataclass(frozen=True)
class Effect(Part):
    """Base of effects; a subclass defines static functions named after the ports it changes.

    The functions take and return floats in SI units (scalars; the only arrays are those named so
    below) and ask by name for the signals, parameters and states that they use.  Surfaces that rub
    along lengths have forces [N] and speeds [m/s] in place of torques [N m] and speeds [rad/s].

    On a clutch (``clutch`` >= 0 is its index; each receives the value so far and returns the new
    one, but ``bristle_torque``):
        ``slip_torque(torque, speed, direction, ...)``
            Size of the friction torque while it slips [N m], 0 or more.
        ``break_torque(torque, direction, ...)``
            Size of the torque at which it breaks away from rest [N m].
        ``effective_excitation(excitation, ...)``
            Excitation of which the torque map makes the torques [V].
        ``seen_command(command, ...)``
            Command that its actuator sees [V].
        ``excitation_rate(rate, excitation, command, ...)``
            Rate of its excitation [V/s]; like its command only of a clutch with a lag.
        ``bristle_torque(level, breakaway, ...)``
            Torque against positive slip [N m], with sign, in place of stiction; such a clutch never
            sticks (its mode stays FORWARD).
        ``bristle_side(...)``
            Beside it: above 0 while what is wound bears against positive slip. Of such a clutch
            this is the ``direction`` of its torque map (without it, that of its slip).
    On a coordinate (``coordinate`` >= 0 is its index):
        ``force(speed, position, time, ...)``
            A generalized force to be added [N m or N].
        ``inertia(position, ...)``
            An inertia to be added on the diagonal [kg m^2 or kg], constant in time.
    States:
        every name in ``states`` has a ``<name>_rate(...)`` [its unit/s]; states start at 0, those
        in ``settled`` at the clutch's excitation, of a coordinate at its speed, when a run begins
        (and where a replay sets the speed anew, the state is changed by as much).
    Guards:
        every name in ``guards`` has a ``<name>_guard(...)``, a number above 0 while nothing
        happens, and a ``<name>_jump(t, y, p, held, dmode, states_at, modes_at)`` that changes
        states (``y`` from ``states_at`` on) and discrete modes (``dmode`` from ``modes_at`` on;
        ``modes`` counts them) when it falls through zero.  It returns nothing; ``t`` [s], ``y``
        (ny,) is the whole state vector, in which ``excitation_at`` is its clutch's excitation [V],
        ``p`` all parameters, ``held`` (nh,) as for controllers, ``dmode`` (nd,) integers.
    Numbers:
        Methods ``changed_delay(delay)``, ``changed_threshold(threshold)`` replace the clutch's.

    Signals of a clutch: ``time`` [s], ``slip`` and its size ``speed`` [rad/s], ``direction`` (1 or
    -1), ``angle`` (C q [rad], 0 where all coordinates are; its rate is the slip if the clutch's row
    of the map C is constant, else it is refused), ``excitation``, ``effective`` (excitation after
    ``effective_excitation``), ``command`` and, before effects on it, ``told_command`` [V];
    for torques ``applied, conservative`` (loads' and potential forces along the slip [N m]) and, of
    a single coordinate with a single clutch, ``net, mass`` (all forces but friction [N m], and
    inertia [kg m^2]); in rates also ``torque`` [N m], ``rate`` (of the excitation [V/s]),
    ``engaged`` (1 or 0), with a ``bristle_torque`` ``level, breakaway`` [N m]; in guards ``rate,
    slip, level, breakaway``. Of a coordinate: ``position`` [rad or m], ``speed`` [rad/s or m/s],
    ``coordinate`` (its index). Of all: parameters, states, and ``held_<name>`` by name.
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

    #: Whether it knows a motor only with its ends closed: a driver that opens them between pulses
    #: lets no current through it to be cut or to warm anything.
    ends_closed: ClassVar[bool] = False
    #: Its numbers that are those of its coordinate's motor: ``constant`` (force for each unit of
    #: the drive), ``back`` (what speed takes of it).  Where a fit moves the motor's they follow.
    of_motor: ClassVar[tuple[str, ...]] = ()

    clutch: int = -1
    coordinate: int = -1

    def follows(self) -> str:
        """Logged channel of a recording whose course its ``points`` are; "" if it has none."""
        return ""

    def changed_delay(self, delay: float) -> float:
        """Off-to-on delay of the clutch it acts on [s], given that without it.

        Parameters
        ----------
        delay : float
            The clutch's own, or as earlier effects changed it [s].

        Returns
        -------
        float
            [s].
        """
        return delay

    def changed_threshold(self, threshold: float) -> float:
        """Off threshold of the clutch it acts on [V], given that without it.

        Parameters
        ----------
        threshold : float
            The clutch's own, or as earlier effects changed it [V].

        Returns
        -------
        float
            [V].
        """
        return threshold
