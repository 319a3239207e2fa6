"""A run's quantities at N instants, as arrays; made by ``sampling.sample``."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any

import numpy as np


@dataclass(frozen=True)
class Samples:
    """Quantities at N instants of a run with n coordinates and m clutches.

    Parameters
    ----------
    t : ndarray, (N,)
        Instants [s].
    side : ndarray of str, (N,)
        ``left`` or ``right``: the side of an event that is meant.
    segment : ndarray of int, (N,)
    q, qd, qdd : ndarray, (N, n)
        Coordinates, speeds, accelerations [rad or m, per s, per s^2].
    mode, gate : ndarray of int, (N, m)
        BACKWARD -1, STICK 0, FORWARD 1, FREE 2; OFF 0, CLOSING 1, ON 2.
    slip : ndarray, (N, m)
        Slip velocities [rad/s]; exactly 0.0 for a stuck clutch.
    excitation : ndarray, (N, m)
        [V].
    tau : ndarray, (N, m)
        Clutch torques [N m]; a positive torque opposes backward slip.
    unique : ndarray of bool, (N, m)
        False where a stuck set is redundant and ``tau`` a stated convention (least sum of
        (tau/tau_break)^2), not a consequence of the equations of motion.
    tau_break_forward, tau_break_backward : ndarray, (N, m)
        Breakaway torques in both directions [N m]; while slipping, what the clutch could hold if it
        were at rest; 0 when off.
    tau_slip : ndarray, (N, m)
        Magnitude of the slip torque; of a stuck clutch at 0+, the smaller of both directions [N m].
    margin : ndarray, (N,)
        Least stick margin [N m]; inf where nothing is stuck.
    held : mapping of str to ndarray, (N,)
        Held inputs by name: ``command_1`` ..., then those the controllers add.
    effect : mapping of str to ndarray, (N,)
        States of the effects by name.
    load : ndarray, (N, n)
        Generalized force of the loads [N m or N].
    tip, tip_velocity, tip_acceleration : ndarray, (N, 2), or None
        [m, m/s, m/s^2]; None for a device without a tip.
    tip_force : ndarray, (N, 2), or None
        Sum of the loads' forces on the tip [N]; None for a device without a tip.
    kinetic : ndarray, (N,)
        Kinetic energy [J].
    potential : ndarray, (N,), or None
        Potential energy [J]; None where the device has conservative forces but no
        ``potential_energy``.
    work_load, work_effects : ndarray, (N,)
        Work done since the start by the loads and by the effects' forces [J].
    dissipated : ndarray, (N, m)
        Energy dissipated since the start by every clutch [J].
    """

    t: np.ndarray
    side: np.ndarray
    segment: np.ndarray
    q: np.ndarray
    qd: np.ndarray
    qdd: np.ndarray
    mode: np.ndarray
    gate: np.ndarray
    slip: np.ndarray
    excitation: np.ndarray
    tau: np.ndarray
    unique: np.ndarray
    tau_break_forward: np.ndarray
    tau_break_backward: np.ndarray
    tau_slip: np.ndarray
    margin: np.ndarray
    held: Mapping[str, np.ndarray]
    effect: Mapping[str, np.ndarray]
    load: np.ndarray
    # Arrays, or None for a device without a tip: whoever asks knows which device it is.
    tip: Any
    tip_velocity: Any
    tip_acceleration: Any
    tip_force: Any
    kinetic: np.ndarray
    potential: np.ndarray | None
    work_load: np.ndarray
    work_effects: np.ndarray
    dissipated: np.ndarray

    def rows(self, rows: np.ndarray) -> Samples:
        """The same at some of the instants, by their numbers."""

        def part(values: Any) -> Any:
            if isinstance(values, Mapping):
                return {name: own[rows] for name, own in values.items()}
            return None if values is None else values[rows]

        return Samples(**{f.name: part(getattr(self, f.name)) for f in fields(self)})

    @property
    def tau_break(self) -> np.ndarray:
        """Breakaway torque in the weaker direction [N m]; (N, m)."""
        return np.minimum(self.tau_break_forward, self.tau_break_backward)

    @property
    def acceleration(self) -> np.ndarray:
        """Acceleration (N, 2) of the tip, or (N, n) of the coordinates of a device without one."""
        return self.qdd if self.tip_acceleration is None else self.tip_acceleration
