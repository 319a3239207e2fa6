"""The tip's position and acceleration at many instants at once, by the device's own functions."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable
from types import FunctionType, ModuleType, SimpleNamespace
from typing import Any

import numpy as np

from ..scenario import Scenario

_RENAMED = {"asin": "arcsin", "acos": "arccos", "atan": "arctan", "atan2": "arctan2",
            "pow": "power"}  # fmt: skip
_NAMES = ("sin", "cos", "tan", "sqrt", "exp", "log", "hypot", "copysign", "sinh", "cosh", "tanh")
#: NumPy's functions under the names of ``math``'s.
ARRAY_MATH = SimpleNamespace(
    pi=math.pi, e=math.e, **{name: getattr(np, name) for name in _NAMES},
    **{name: getattr(np, own) for name, own in _RENAMED.items()},
)  # fmt: skip


@functools.lru_cache(maxsize=256)
def on_arrays(function: Callable) -> Callable:
    """A function that computes on arrays: the given one with NumPy's mathematics for Python's.

    Parameters
    ----------
    function : callable
        It must not branch on what it computes; what is no plain function is handed back as it is.
    """
    if not isinstance(function, FunctionType):
        return function
    space = dict(function.__globals__)
    for name in function.__code__.co_names:
        value = space.get(name)
        if isinstance(value, ModuleType) and value is math:
            space[name] = ARRAY_MATH
        elif isinstance(value, FunctionType):
            space[name] = on_arrays(value)
        elif getattr(math, name, None) is value and value is not None:
            space[name] = getattr(ARRAY_MATH, name)
    return FunctionType(function.__code__, space, function.__name__, function.__defaults__)


def tip_motion(
    scenario: Scenario, q: np.ndarray, qd: np.ndarray, qdd: np.ndarray
) -> tuple[Any, np.ndarray]:
    """Position (N, 2) [m] and acceleration (N, 2) [m/s^2] of the tip.

    For a device without a tip the position is None, and the acceleration (N, n) that of its
    coordinates.

    Parameters
    ----------
    scenario : Scenario
        Its device gives the functions of the tip, and its parameters their numbers.
    q, qd, qdd : ndarray, (N, n)
        Coordinates, their speeds and accelerations at N instants [rad or m, and per s and s^2].
    """
    functions = scenario.device.functions()
    if "tip" not in functions:
        return None, qdd
    p = scenario.parameter_values()
    three = [functions[name] for name in ("tip", "tip_jacobian", "tip_jacobian_rate")]
    try:
        at, speeds, rates = (_read_only(values) for values in (q, qd, qdd))
        found = _evaluated([on_arrays(f) for f in three], at, speeds, rates, p)
        if _as_alone(found, three, q, qd, qdd, p):
            return found
    except (TypeError, ValueError, AttributeError):
        pass  # it branches, works in place, or uses other mathematics
    rows = [
        _evaluated(three, a.tolist(), b.tolist(), c.tolist(), p)
        for a, b, c in zip(q, qd, qdd, strict=True)
    ]
    return np.array([r[0][0] for r in rows]), np.array([r[1][0] for r in rows])


def _read_only(values: np.ndarray) -> list[np.ndarray]:
    """Columns that refuse ``out[0] = q[0]; out[0] *= ...``, which is right for numbers only."""
    columns = values.T.copy()
    columns.flags.writeable = False
    return list(columns)


def _as_alone(
    found: Any, functions: list[Callable], q: np.ndarray, qd: np.ndarray, qdd: np.ndarray, p: Any
) -> bool:
    """Whether the instant of fastest motion has the same numbers where it is evaluated alone.

    Arrays of the device's own that it changes in place after it handed them out go on changing.
    """
    speed = np.abs(qd).sum(axis=1)
    there = np.flatnonzero(np.isfinite(speed + np.abs(q).sum(axis=1) + np.abs(qdd).sum(axis=1)))
    if not len(there):
        return True  # no instant of which anything is known
    k = there[speed[there].argmax()]
    alone = _evaluated(functions, q[k].tolist(), qd[k].tolist(), qdd[k].tolist(), p)
    return all(
        np.allclose(whole[k], one[0], rtol=1e-9, atol=1e-9 * float(np.abs(one).max()))
        for whole, one in zip(found, alone, strict=True)
    )


def _evaluated(functions: list[Callable], q: list, qd: list, qdd: list, p: list[float]) -> Any:
    n = len(q)
    point, jacobian, rate = [0.0] * 2, [0.0] * (2 * n), [0.0] * 2
    functions[0](q, p, point)
    functions[1](q, p, jacobian)
    functions[2](q, qd, p, rate)
    acceleration = [sum(jacobian[k * n + j] * qdd[j] for j in range(n)) + rate[k] for k in range(2)]
    count = np.shape(q[0]) or (1,)
    columns = [np.broadcast_to(np.asarray(v, dtype=float), count) for v in point]
    return np.stack(columns, axis=-1), np.stack(
        [np.broadcast_to(np.asarray(v, dtype=float), count) for v in acceleration], axis=-1
    )
