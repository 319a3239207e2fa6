"""The energy budget of a run: an identity of the model that a computed run meets or misses."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass

import numpy as np

from ..trajectory import Trajectory
from .samples import Samples
from .sampling import sample

#: Slip that beside an event is solver error, in absolute tolerances: a state may err by the root of
#: their number of these in one step, and a few steps add up.
SLIP_ERROR = 10.0
#: A run that turns over less than this share of the energy it carries is at rest or coasts: what
#: it turns over may be rounding and the solver's error alone.
NOTHING = 1e-7


@dataclass(frozen=True)
class EnergyBalance:
    """Energy budget from the start to the end of a run [J].

    Work and dissipation were integrated along the motion, never obtained by difference, so that
    ``stored + dissipated - work`` is a check.

    Parameters
    ----------
    stored_start, stored_end : float or None
        Kinetic plus potential energy; None where the device has conservative forces but no
        ``potential_energy``.
    work_load, work_effects : float
        Done on the device by the loads and by the effects' forces.
    dissipated : tuple of float, (m,)
        By every clutch.
    residual : float or None
        Largest magnitude of what is missing at any of the instants looked at.
    turnover : float
        What the residual is measured by: the largest, over the instants, of the energy that has
        been stored, worked, dissipated, or exchanged (kinetic or potential energy above its least:
        a swing without friction exchanges energy while their sum stays).
    relative : float or None
        ``residual / turnover``; of a run at rest or coasting, which turns over less than
        ``NOTHING`` of the energy it carries, ``residual`` by that energy. None also where energies
        are too large for a number.
    max_clutch_power : float
        Largest power that any clutch delivers [W]; a clutch can only take energy, so never above 0.
    """

    stored_start: float | None
    stored_end: float | None
    work_load: float
    work_effects: float
    dissipated: tuple[float, ...]
    residual: float | None
    turnover: float
    relative: float | None
    max_clutch_power: float

    def as_dict(self) -> dict:
        """Ready for JSON."""
        return asdict(self)


def stored_energy(samples: Samples) -> np.ndarray | None:
    """Kinetic plus potential energy [J]; (N,), or None where it is not known."""
    return None if samples.potential is None else samples.kinetic + samples.potential


def residual(samples: Samples) -> np.ndarray | None:
    """``E(t) - E(0) - work + dissipation`` [J]; (N,), or None where E is not known.

    The first of ``samples`` has to be the start of the run.
    """
    stored = stored_energy(samples)
    if stored is None:
        return None
    work = samples.work_load + samples.work_effects
    return stored - stored[0] - work + samples.dissipated.sum(axis=1)


def energy_balance(trajectory: Trajectory, samples: Samples | None = None) -> EnergyBalance:
    """Balance a run's energy at ``samples`` (the default output grid when left out)."""
    s = sample(trajectory) if samples is None else samples
    with np.errstate(over="ignore", invalid="ignore"):  # what overflows shows in the result
        return _balance(s)


def power_beyond_tolerance(trajectory: Trajectory, samples: Samples | None = None) -> float:
    """Largest power that a clutch delivers beyond what the solver's error in a slip explains [W].

    Beside an event, where the slip is 0, it may have the wrong sign by about the absolute
    tolerance; times the clutch's largest torque that is power which says nothing of its friction.
    """
    s = sample(trajectory) if samples is None else samples
    with np.errstate(over="ignore", invalid="ignore"):
        noise = SLIP_ERROR * trajectory.scenario.atol * abs(s.tau).max(axis=0, initial=0.0)
        return float((s.tau * s.slip - noise).max(initial=0.0))


def _balance(s: Samples) -> EnergyBalance:
    stored, missing = stored_energy(s), residual(s)
    lost = s.dissipated.sum(axis=1)
    parts = [abs(s.work_load) + abs(s.work_effects), abs(lost)]
    if stored is not None and s.potential is not None:
        # Where nothing works or rubs the sum changes by the residual only, so each counts alone.
        parts += [each - each.min() for each in (stored, s.kinetic, s.potential)]
    turnover = float(np.max(parts))
    worst = None if missing is None else float(abs(missing).max())
    if worst is None or s.potential is None or not math.isfinite(turnover):
        relative = None
    else:
        carried = float(np.max([s.kinetic, abs(s.potential)]))
        whole = turnover if turnover > NOTHING * carried else carried
        relative = worst / whole if whole > 0.0 else 0.0
    return EnergyBalance(
        stored_start=None if stored is None else float(stored[0]),
        stored_end=None if stored is None else float(stored[-1]),
        work_load=float(s.work_load[-1]),
        work_effects=float(s.work_effects[-1]),
        dissipated=tuple(s.dissipated[-1].tolist()),
        residual=worst,
        turnover=turnover,
        relative=relative,
        max_clutch_power=float((s.tau * s.slip).max(initial=0.0) + 0.0),
    )
