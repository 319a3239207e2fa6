"""Diagnosis of printed measurements: slip torque at six speeds (Tables 3, 4) against (39).

The 246 points are lost, but each speed's own quadratic and its sum of squares are printed.  A
least-squares residual is orthogonal to every quadratic; so for any model that is a quadratic in the
excitation at each speed the sum of squares over the lost points is the printed one plus that of the
distance to the printed quadratic, and models can be fitted and judged exactly.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ..effects.degressive_speed import DegressiveSpeed
from ..effects.logarithmic_speed import LogarithmicSpeed
from ..effects.stribeck import Stribeck
from .friction_fits import FITS, SPEEDS, TABLE_3, VOLTS, polynomial

#: Printed: offset of the speed factor is kept, since it only scales the quadratic.
OFFSET = 0.9409
PRINTED = (0.154, 6.439, 0.137, 0.371)
#: What the six quadratics leave: no model that is a quadratic at each speed can do better.
PURE = np.array([sse for sse, _ in TABLE_3])
FITTED = np.array([polynomial(fit) for fit in FITS])
POINTS = VOLTS.size
#: Speed above which `LogarithmicSpeed` is logarithmic: its default [rad/s].
SCALE = 0.05


@dataclass(frozen=True)
class Form:
    """A model of slip torque: name, further parameters' starts, torque at the 41 excitations."""

    name: str
    starts: tuple[float, ...]
    torque: Callable[[np.ndarray, float], np.ndarray]


@dataclass(frozen=True)
class Judged:
    """A fitted form: values, root mean square over 246 points, and on speeds left out [lb-in]."""

    name: str
    values: np.ndarray
    error: float
    left_out: float
    lack_of_fit: float


def declared(x: np.ndarray, speed: float) -> np.ndarray:
    """Equation (39) with its four free numbers [lb-in]."""
    return (x[0] * speed + OFFSET) * np.polyval(x[1:4], VOLTS)


def factor(effect: type, *fixed: float) -> Callable[[np.ndarray, float], np.ndarray]:
    """Equation (39) times an effect's factor on slip torque, by the effect's own function."""

    def torque(x: np.ndarray, speed: float) -> np.ndarray:
        own = [x[4], *(1e-3 + abs(v) for v in x[5:]), *fixed]
        return declared(x, speed) * effect.slip_torque(1.0, speed, *own)  # type: ignore[attr-defined]

    return torque


FORMS = (
    Form("(39) refitted", (), declared),
    Form("logarithmic-speed", (0.0,), factor(LogarithmicSpeed, SCALE)),
    Form("degressive-speed", (0.2, 0.5), factor(DegressiveSpeed)),
    Form("stribeck", (-0.1, 0.5), factor(Stribeck, 1.0)),
    Form("viscous-drag", (0.0,), lambda x, w: declared(x, w) + x[4] * w),
    Form("quadratic-drag", (0.0,), lambda x, w: declared(x, w) + x[4] * w * w),
)


def squares(form: Form, x: np.ndarray, which: list[int]) -> np.ndarray:
    """Sum of squares over the 41 lost points of each of the speeds `which` [(lb-in)^2]."""
    apart = [form.torque(x, SPEEDS[i]) - FITTED[i] for i in which]
    return PURE[which] + np.array([float(a @ a) for a in apart])


def fitted(form: Form, which: list[int]) -> np.ndarray:
    """Least squares over the points of some speeds."""
    from scipy.optimize import least_squares

    def apart(x: np.ndarray) -> np.ndarray:
        return np.concatenate([form.torque(x, SPEEDS[i]) - FITTED[i] for i in which])

    return least_squares(apart, [*PRINTED, *form.starts], x_scale="jac").x


def judge(form: Form) -> Judged:
    """Fit to all six speeds; and to five, judged on the sixth, each in turn."""
    all_six = list(range(6))
    x = fitted(form, all_six)
    total = float(squares(form, x, all_six).sum())
    held_out = [
        float(squares(form, fitted(form, [j for j in all_six if j != i]), [i])[0]) for i in all_six
    ]
    spare = 18 - 4 - len(form.starts)
    scatter = float(PURE.sum()) / (6 * POINTS - 18)
    lack = (total - float(PURE.sum())) / spare / scatter
    return Judged(
        form.name, x, float(np.sqrt(total / (6 * POINTS))),
        float(np.sqrt(sum(held_out) / (6 * POINTS))), lack,
    )  # fmt: skip
