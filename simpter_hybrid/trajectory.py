"""The result of a run: dense in time, both sides of every event."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np


@dataclass(frozen=True)
class Event:
    """One transition.

    Parameters
    ----------
    t : float
        Instant [s].
    kind : str
        ``start``, ``switched`` (on or off), ``slip stop``, ``effect``, ``breakaway``.
    clutches : tuple of int
        Clutches (from 1) whose mode changed; several stop or let go at once as a set.
    before, after : tuple of int, (m,)
        Modes: BACKWARD -1, STICK 0, FORWARD +1, FREE 2; before a run starts, 3 where a clutch is
        engaged and has none yet.
    case_before, case_after : str
        Thesis case numbers where the device has them.
    margin : float
        Margin at a breakaway [N m or N]; 0 elsewhere.
    note : str
    """

    t: float
    kind: str
    clutches: tuple[int, ...]
    before: tuple[int, ...]
    after: tuple[int, ...]
    case_before: str = ""
    case_after: str = ""
    margin: float = 0.0
    note: str = ""


@dataclass(frozen=True, repr=False)
class Trajectory:
    """A run, dense in time.

    The state is a polynomial within every solver step, ``y(t) = y0 + x (F0 + (1-x)(F1 + x (F2 +
    ...)))`` with ``x = (t - t0)/h`` (the form of DOP853's dense output, which has seven
    rows; that of RK45 has four; three are a cubic Hermite polynomial).

    Parameters
    ----------
    step_t, step_h : ndarray, (S,)
    step_y : ndarray, (S, ny)
    step_f : ndarray, (S, 3, 4 or 7, ny)
    step_segment : ndarray of int, (S,)
    segment_t : ndarray, (K, 2)
        First and last instant of every segment.
    mode, gate : ndarray of int, (K, m)
    held : ndarray, (K, nh)
        Held inputs of every segment, the clutch commands first.
    dmode : ndarray of int, (K, nd)
    end : ndarray, (ny,)
        Final state.
    events : tuple of Event
    status : str
        ``finished``, ``stopped`` (a located stop condition), ``failed`` or ``interrupted``.
    message : str
    statistics : mapping
        Counts: segments, steps, events, and what else the engine counts.
    engine : str
    scenario : Scenario
    """

    step_t: np.ndarray
    step_h: np.ndarray
    step_y: np.ndarray
    step_f: np.ndarray
    step_segment: np.ndarray
    segment_t: np.ndarray
    mode: np.ndarray
    gate: np.ndarray
    held: np.ndarray
    dmode: np.ndarray
    end: np.ndarray
    events: tuple[Event, ...]
    status: str
    message: str
    statistics: dict[str, Any]
    engine: str
    scenario: Any

    def __repr__(self) -> str:
        name = getattr(self.scenario, "name", "unnamed")
        counts = f"{len(self.segment_t)} segments, {len(self.events)} events"
        return f"<Trajectory {name}, {self.status}: {self.message}; {counts}>"

    @property
    def t_end(self) -> float:
        """Last instant [s]; 0.0 of a run that has no segment."""
        return float(self.segment_t[-1, 1]) if len(self.segment_t) else 0.0

    def segment_at(self, t: float, side: str = "right") -> int:
        """The segment that holds ``t``; at an event the one after it (``right``) or before.

        Parameters
        ----------
        t : float
            [s].
        side : str
            ``right`` or ``left``.

        Returns
        -------
        int
            From 0; the first or the last segment where ``t`` is outside the run.
        """
        if side == "right":
            k = int(np.searchsorted(self.segment_t[:, 0], t, side="right")) - 1
        else:
            k = int(np.searchsorted(self.segment_t[:, 1], t, side="left"))
        return min(max(k, 0), len(self.segment_t) - 1)

    def state(self, t: float, side: str = "right") -> np.ndarray:
        """State vector at ``t`` (ny,).

        Parameters
        ----------
        t : float
            [s].
        side : str
            As for `segment_at`.

        Raises
        ------
        ValueError
            If ``t`` [s] is outside the run.
        """
        first = float(self.segment_t[0, 0]) if len(self.segment_t) else 0.0
        if not first <= t <= self.t_end:
            raise ValueError(
                f"t = {t} s is outside the run, which covers {first} s to {self.t_end} s"
            )
        if t == self.t_end:
            return self.end.copy()
        k = self.segment_at(t, side)
        first = int(np.searchsorted(self.step_segment, k, side="left"))
        last = int(np.searchsorted(self.step_segment, k, side="right")) - 1
        if last < first:
            following = min(first, len(self.step_t) - 1)
            return self.step_y[following].copy()
        j = int(np.searchsorted(self.step_t[first : last + 1], t, side="right")) - 1 + first
        j = min(max(j, first), last)
        return polynomial(self.step_y[j], self.step_f[j], (t - self.step_t[j]) / self.step_h[j])


def polynomial(y0: np.ndarray, rows: np.ndarray, x: float) -> np.ndarray:
    """``y0 + x (F0 + (1-x)(F1 + x (F2 + (1-x)(...))))``, the nested dense-output polynomial.

    Parameters
    ----------
    y0 : ndarray (ny,)
        State where the step begins.
    rows : ndarray (nf, ny)
        F0, F1, ...
    x : float
        Share of the step, from 0 to 1.
    """
    y = np.zeros_like(y0)
    for i in range(len(rows) - 1, -1, -1):
        y = (y + rows[i]) * (x if i % 2 == 0 else 1.0 - x)
    return y + y0
