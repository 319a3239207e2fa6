"""What a curve in another coordinate, or a level of each run, would do of what an effect does."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ..recordings.projection import beyond
from .curve import learned_curve, on_curve
from .trace import Trace

#: A coordinate with less than this share of its variance within runs stays where it is in them.
MOVES = 0.1
#: Nothing is said of a signal of which one offset and one scale leave less than this part.
SCALED = 0.2


def imitated(learned: Sequence[Trace], tested: Sequence[Trace], names: Sequence[str]) -> dict:
    """Part of an effect's signal, held out, that a curve in each of `names` takes away.

    Beyond what one offset and one scale do, which are curves in any coordinate; nothing is said
    where these do most of it.
    """
    whole = float(sum(t.residual @ t.residual for t in tested))
    learned, tested = _beyond_scale(learned, tested)
    signal = np.concatenate([t.residual for t in tested])
    total = float(signal @ signal)
    found = {}
    for name in names if total > SCALED * whole else ():
        edges, _, curve = learned_curve(learned, name)
        told = [on_curve(edges, curve, t.coordinates[name], t.torque) for t in tested]
        left = signal - np.concatenate(told)
        found[name] = 1.0 - float(left @ left) / total
    return found


def _beyond_scale(learned: Sequence[Trace], tested: Sequence[Trace]):
    """Residuals less the offset and the scale learned on the first."""
    torque = np.concatenate([t.torque for t in learned])
    signal = np.concatenate([t.residual for t in learned])
    columns = np.column_stack([np.ones(torque.size), torque])
    offset, scale = np.linalg.lstsq(columns, signal, rcond=None)[0]
    return tuple(
        [replace(t, residual=t.residual - offset - scale * t.torque) for t in traces]
        for traces in (learned, tested)
    )


def imitated_by_runs(tested: Sequence[Trace], own: Sequence[str]) -> float:
    """Part of an effect's signal that an offset and a scale for each run take away.

    0 if any of the effect's coordinates `own` moves within runs.  A coordinate that stays where it
    is in every run differs between runs as anything else may (a temperature, a wear, a gain), so a
    dependence on it alone carries no name.
    """
    signal = np.concatenate([t.residual for t in tested])
    total = float(signal @ signal)
    if total == 0.0 or not own or max(_moves(tested, name) for name in own) > MOVES:
        return 0.0
    left = 0.0
    for t in tested:
        columns = np.column_stack([np.ones(t.torque.size), t.torque])
        rest = beyond(t.residual, columns)
        left += float(rest @ rest)
    return 1.0 - left / total


def _moves(traces: Sequence[Trace], name: str) -> float:
    """Share of a coordinate's variance that lies within runs, where the signal is."""
    x = [t.coordinates[name] for t in traces]
    weights = [t.residual**2 for t in traces]
    mass = np.array([w.sum() for w in weights])
    kept = [k for k in range(len(x)) if mass[k] > 0.0]
    means = np.array([float(weights[k] @ x[k]) / mass[k] for k in kept])
    share = mass[kept] / mass.sum()
    within = sum(float(weights[k] @ (x[k] - m) ** 2) for k, m in zip(kept, means, strict=True))
    within /= float(mass.sum())
    between = float(share @ (means - share @ means) ** 2)
    return within / (within + between) if within + between > 0.0 else 1.0
