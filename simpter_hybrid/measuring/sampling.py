"""A run's quantities at chosen instants, as arrays."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ..kernel.records import BACKWARD, FORWARD
from ..trajectory import Trajectory
from .evaluation import Evaluation, states
from .samples import Samples


def output_grid(trajectory: Trajectory, step: float | None = None) -> tuple[np.ndarray, np.ndarray]:
    """The default instants of output: multiples of ``step``, and both sides of every segment's end.

    Events and samples end segments, so every jump of a quantity shows both its values.

    Parameters
    ----------
    trajectory : Trajectory
        The run whose output instants are wanted.
    step : float, optional
        Spacing [s]; a thousandth of the run when left out.

    Returns
    -------
    times, sides : ndarray, (N,)
        Arguments for ``sample``; sorted, the left side of an instant first.

    Raises
    ------
    ValueError
        If ``step`` is not a positive number.
    """
    t_end = trajectory.t_end
    if step is None:
        step = t_end / 1000.0 or 1.0
    if not step > 0.0:
        raise ValueError(f"the output step is {step} s; it has to be greater than 0 s")
    uniform = np.append(np.arange(int(np.floor(t_end / step)) + 1) * step, t_end)
    inner = np.unique(trajectory.segment_t[1:, 0])
    inner = inner[(inner > 0.0) & (inner < t_end)]
    both = [(t, "right") for t in np.unique(uniform[uniform <= t_end])] + [
        (t, side) for t in inner for side in ("left", "right")
    ]
    ordered = sorted(set(both))
    return np.array([t for t, _ in ordered]), np.array([side for _, side in ordered])


def held_names(scenario) -> list[str]:
    """Names of the held inputs, in their order."""
    return [f"command_{i + 1}" for i in range(scenario.device.m)] + list(scenario.text.a.held)


def sample(
    trajectory: Trajectory,
    times: Sequence[float] | np.ndarray | None = None,
    side: str | Sequence[str] | np.ndarray = "right",
) -> Samples:
    """Everything there is to know about a run at ``times``.

    Parameters
    ----------
    trajectory : Trajectory
        The run to sample.
    times : sequence of float, optional
        Instants [s], in any order; ``output_grid`` when left out.
    side : str or sequence of str
        ``right`` (after an event) or ``left`` (before it), for all or for each.

    Raises
    ------
    ValueError
        For instants outside the run and for other sides, and for a run that has no segment.
    """
    if len(trajectory.segment_t) == 0:
        raise ValueError(f"the run has no segment to sample: {trajectory.message}")
    if times is None:
        times, side = output_grid(trajectory)
    t = np.atleast_1d(np.asarray(times, dtype=float))
    sides = np.broadcast_to(np.asarray(side), t.shape)
    _check(trajectory, t, sides)
    after = np.searchsorted(trajectory.segment_t[:, 0], t, side="right") - 1
    before = np.searchsorted(trajectory.segment_t[:, 1], t, side="left")
    segment = np.clip(np.where(sides == "right", after, before), 0, len(trajectory.segment_t) - 1)
    return sample_segments(trajectory, t, segment, sides.copy())


def sample_segments(
    trajectory: Trajectory, t: np.ndarray, segment: np.ndarray, sides: np.ndarray | None = None
) -> Samples:
    """As ``sample``, each instant taken from the segment given (an end of which it may be)."""
    y = states(trajectory, t, segment)
    columns = _evaluate(trajectory, t, segment, y)
    return Samples(
        t=t,
        side=np.full(t.shape, "right") if sides is None else sides,
        segment=segment,
        mode=trajectory.mode[segment],
        gate=trajectory.gate[segment],
        held=dict(zip(held_names(trajectory.scenario), trajectory.held[segment].T, strict=False)),
        **_columns_of_state(trajectory, y),
        **columns,
    )


def _check(trajectory: Trajectory, t: np.ndarray, sides: np.ndarray) -> None:
    first, last = trajectory.segment_t[0, 0], trajectory.t_end
    outside = t[~((t >= first) & (t <= last))]
    if outside.size:
        raise ValueError(
            f"t = {outside[0]} s is outside the run, which covers {first} s to {last} s"
        )
    wrong = set(sides.tolist()) - {"left", "right"}
    if wrong:
        raise ValueError(f"side {wrong.pop()!r} is unknown; it has to be 'left' or 'right'")


def _columns_of_state(trajectory: Trajectory, y: np.ndarray) -> dict[str, Any]:
    scenario = trajectory.scenario
    n, m = scenario.device.n, scenario.device.m
    names = scenario.text.a.states
    ledger = 2 * n + m + len(names)
    return {
        "q": y[:, :n],
        "excitation": y[:, 2 * n : 2 * n + m],
        "effect": {name: y[:, 2 * n + m + k] for k, name in enumerate(names)},
        "work_load": y[:, ledger],
        "work_effects": y[:, ledger + 1],
        "dissipated": y[:, ledger + 2 : ledger + 2 + m],
    }


def _evaluate(
    trajectory: Trajectory, t: np.ndarray, segment: np.ndarray, y: np.ndarray
) -> dict[str, Any]:
    """The columns that take the model, one instant after the other."""
    view = Evaluation(trajectory)
    rows: list[dict] = []
    another = segment[np.flatnonzero(np.diff(segment, prepend=-1))]
    starts = iter(states(trajectory, trajectory.segment_t[another, 0], another).tolist())
    entered = -1
    for time, k, state in zip(t.tolist(), segment.tolist(), y.tolist(), strict=True):
        if k != entered:
            view.enter(k, next(starts))
            entered = k
        rows.append(_row(view, time, view.at(time, state)))
    columns = {name: np.array([row[name] for row in rows]) for name in rows[0]} if rows else {}
    return {
        name: columns.get(name)
        for name in (
            "qd", "qdd", "slip", "tau", "unique", "tau_break_forward", "tau_break_backward",
            "tau_slip", "margin", "load", "tip", "tip_velocity", "tip_acceleration",
            "tip_force", "kinetic", "potential",
        )
    }  # fmt: skip


def _row(view: Evaluation, t: float, y: list[float]) -> dict:
    md, w = view.md, view.w
    n, m, fr = md.n, md.m, view.w.fr
    qd, qdd, mode = y[n : 2 * n], w.qdd[:n], view.mode
    row = {
        "qd": qd,
        "qdd": qdd.copy(),
        "slip": view.slip(y),
        "tau": w.tau[:m],
        "unique": view.unique(),
        "tau_break_forward": fr[m : 2 * m],
        "tau_break_backward": fr[2 * m : 3 * m],
        "tau_slip": [
            fr[i] if mode[i] in (FORWARD, BACKWARD) else min(fr[3 * m + i], fr[4 * m + i])
            for i in range(m)
        ],
        "margin": min(view.margins(), default=np.inf),
        "load": w.Q[:n],
        "kinetic": 0.5 * sum(w.M[a * n + b] * qd[a] * qd[b] for a in range(n) for b in range(n)),
    }
    functions = view.functions
    if "potential_energy" in functions:
        row["potential"] = functions["potential_energy"](y[:n], md.p)
    elif "conservative_force" not in functions:
        row["potential"] = 0.0
    if "tip" in functions:
        row |= _tip(functions, md.p, y[:n], qd, qdd) | {"tip_force": view.tip_force(t, y)}
    return row


def _tip(functions: Mapping, p: list[float], q: list[float], qd: list[float], qdd: list[float]):
    """Position, velocity and acceleration of the tip."""
    n = len(q)
    point, jacobian, rate = [0.0, 0.0], [0.0] * (2 * n), [0.0, 0.0]
    functions["tip"](q, p, point)
    functions["tip_jacobian"](q, p, jacobian)
    functions["tip_jacobian_rate"](q, qd, p, rate)
    rows = [jacobian[:n], jacobian[n:]]
    return {
        "tip": point,
        "tip_velocity": [sum(j * v for j, v in zip(row, qd, strict=True)) for row in rows],
        "tip_acceleration": [
            sum(j * a for j, a in zip(row, qdd, strict=True)) + extra
            for row, extra in zip(rows, rate, strict=True)
        ],
    }
