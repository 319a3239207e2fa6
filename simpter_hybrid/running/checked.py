"""SciPy's methods with interior guard checks, to be handed to ``solve_ivp`` as ``method=``.

``solve_ivp`` looks for sign changes at step ends only, so an excursion that begins and ends inside
a step is missed, whatever the tolerance.  Here every step is looked at between its ends as well; a
step over a dip is taken again so that it ends inside the dip, where ``solve_ivp`` sees it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from scipy.integrate import DOP853, RK45, DenseOutput
from scipy.integrate._ivp.rk import RungeKutta

from ..kernel.rules import instant_width
from ..kernel.search import CHECKS
from ..kernel.tableau import TABLEAUX
from ..trajectory import polynomial


class Nested(DenseOutput):
    """Dense output in the form that a ``Trajectory`` keeps, with any number of rows ``F``."""

    def __init__(self, t_old, t, y_old, F) -> None:
        super().__init__(t_old, t)
        self.h = t - t_old
        self.y_old, self.F = y_old, F

    def _call_impl(self, t):
        x = (t - self.t_old) / self.h
        if t.ndim == 0:
            return polynomial(self.y_old, self.F, x)
        return polynomial(self.y_old[:, None], self.F[:, :, None], x)


class NestedRK45(RK45):
    """RK45 whose dense output has that form; it is the same polynomial."""

    def _dense_output_impl(self):
        h, change = self.h_previous, self.y - self.y_old
        first, last = h * self.K[0], h * self.K[-1]
        rows = [change, first - change, 2.0 * change - last - first]
        rows += [h * np.dot(weights, self.K) for weights in TABLEAUX["RK45"].last]
        return Nested(self.t_old, self.t, self.y_old, np.array(rows))


class Checked(RungeKutta):
    """A method that cannot step over a dip of a guard below zero.

    Parameters
    ----------
    guard_values : callable
        ``guard_values(t, y) -> sequence of float``, positive while the mode may go on.
    end_values : callable
        ``end_values(t_old, t, y) -> sequence of float``, the same where a step from ``t_old`` ends.
    start_values : sequence of float
        Guard values at ``t0``.
    """

    def __init__(
        self,
        fun,
        t0,
        y0,
        t_bound,
        guard_values: Callable[[float, object], Sequence[float]],
        end_values: Callable[[float, float, object], Sequence[float]],
        start_values: Sequence[float],
        owner: list | None = None,
        **options,
    ) -> None:
        super().__init__(fun, t0, y0, t_bound, **options)
        self._guard_values, self._end_values = guard_values, end_values
        #: Guard values where the last step ended.
        self.last = start_values
        self._dense = None
        self.redone = 0
        #: Dense output of the steps taken.
        self.done: list = []
        if owner is not None:
            owner.append(self)

    def _step_impl(self):
        start = (self.t, self.y, self.f)
        ok, message = super()._step_impl()
        for _ in range(20):
            if not ok:
                return ok, message
            self.t_old = start[0]
            self._dense = None
            self._dense = super()._dense_output_impl()
            self._end = self._end_values(start[0], self.t, self.y)
            cut = None
            if self.t - start[0] > instant_width(start[0], self.max_step):
                cut = first_dip(
                    start[0], self.t, self.last, self._end, self._dense, self._guard_values
                )
            if cut is None:
                break
            proposal = self.h_abs
            self.t, self.y, self.f = start
            self.h_abs = cut - start[0]
            self.redone += 1
            ok, message = super()._step_impl()
            self.h_abs = min(proposal, self.h_abs)
        self.last = self._end
        self.done.append(self._dense)
        return ok, message

    def _dense_output_impl(self):
        return self._dense if self._dense is not None else super()._dense_output_impl()


class CheckedDOP853(Checked, DOP853):
    """DOP853 that looks between the ends of its steps."""


class CheckedRK45(Checked, NestedRK45):
    """RK45 that does so."""


#: Checked methods by the name that a scenario gives.
CHECKED = {"DOP853": CheckedDOP853, "RK45": CheckedRK45}


def first_dip(t0, t1, g0, g1, dense, guard_values) -> float | None:
    """An instant strictly inside (t0, t1) at which the step should end instead, or None.

    Inside a dip below zero; or, for a guard that is zero at ``t0`` (a clutch that has just begun to
    slip), the last check before it falls back, so that the guard is armed.

    Parameters
    ----------
    t0, t1 : float
        Ends of the step [s].
    g0, g1 : sequence of float
        Guard values there.
    dense : callable
        State (ny,) at an instant, (ny, k) at k of them.
    guard_values : callable
        ``guard_values(t, y)``, as many as in `g0`.
    """
    h = t1 - t0
    times = [t0 + h * k / (CHECKS + 1) for k in range(1, CHECKS + 1)]
    states = dense(np.array(times)).T.tolist()
    rows = [g0, *(guard_values(t, y) for t, y in zip(times, states, strict=True)), g1]
    times = [t0, *times, t1]
    best = None
    for i in range(len(g0)):
        cut = _dip_of([row[i] for row in rows], times, i, dense, guard_values)
        if cut is not None and (best is None or cut < best):
            best = cut
    return best if best is not None and t0 < best < t1 else None


def _dip_of(g, times, i, dense, guard_values) -> float | None:
    last = len(g) - 1
    if g[0] <= 0.0:
        # Unarmed: find where it has risen, then where it falls again.
        risen = next((k for k in range(1, last + 1) if g[k] != 0.0), None)
        if risen is None:
            return None
        if g[risen] < 0.0:
            # It rose and fell before the first look, or never rose at all: look closer.
            return times[0] + 0.01 * (times[last] - times[0])
        fallen = next((k for k in range(risen + 1, last + 1) if g[k] < 0.0), None)
        if fallen is not None:
            return times[fallen - 1]
    else:
        fallen = next((k for k in range(1, last) if g[k] < 0.0), None)
        if fallen is not None:
            return times[fallen]
    # A guard at zero has no dip before it has risen: the first triple is left out.
    for k in range(1 if g[0] > 0.0 else 2, last):
        if (g[k] <= g[k - 1] and g[k] <= g[k + 1]) or k in (1, last - 1):
            cut = chase(g[k - 1 : k + 2], times[k - 1 : k + 2], i, dense, guard_values)
            if cut is not None:
                return cut
    return None


def chase(g, times, i, dense, guard_values) -> float | None:
    """Follow the parabola through three guard values to a dip below zero, if there is one.

    Parameters
    ----------
    g, times : sequence of three float
        Values of the guard and their instants [s], rising.
    i : int
        Number of the guard, from 0.
    dense, guard_values : callable
        As for `first_dip`.

    Returns
    -------
    float or None
        An instant in the dip [s].
    """
    (a, b, c), (ga, gb, gc) = times, g
    for _ in range(8):
        left, right = (gb - ga) / (b - a), (gc - gb) / (c - b)
        bend = (right - left) / (c - a)
        if bend <= 0.0:
            return None
        t = 0.5 * (a + b) - 0.5 * left / bend
        if not a < t < c:
            return None
        low = gb + (t - b) * (left + bend * (t - a))
        if low > 0.5 * min(ga, gb, gc) and min(ga, gc) > 0.0:
            return None
        value = guard_values(t, dense(t))[i]
        if value < 0.0:
            return t
        if abs(t - b) <= 1e-4 * (c - a):
            return None
        if t < b:
            lower = value <= gb
            a, b, c = (a, t, b) if lower else (t, b, c)
            ga, gb, gc = (ga, value, gb) if lower else (value, gb, gc)
        else:
            lower = value <= gb
            a, b, c = (b, t, c) if lower else (a, b, t)
            ga, gb, gc = (gb, value, gc) if lower else (ga, gb, value)
    return None
