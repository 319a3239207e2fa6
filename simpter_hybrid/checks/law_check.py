"""Is a torque map one of a passive clutch? Checked over its range before anything runs."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable, Iterable
from typing import NamedTuple

from ..clutch import TorqueLaw
from ..device import surface_word
from ..part import arguments_of
from ..units import unit_size

#: Slip speeds at which a map is looked at [rad/s or m/s].
SPEEDS = (0.0, 1e-6, 0.01, 0.1, 0.2, 0.5, 1.0, 1.5, 2.0, 5.0, 10.0, 20.0)
#: Excitations in each pass; the second pass looks closer at the worst place of the first.
STEPS = 400


class LawFinding(NamedTuple):
    """What is wrong with a torque map: what, where with which values, what would be right."""

    what: str
    value: str
    right: str


def check_law(
    law: TorqueLaw, full_scale: float, units: tuple[str, str] = ("rad/s", "N m")
) -> list[LawFinding]:
    """Findings about a map from 0 V to ``full_scale`` [V] and at speeds up to 20 rad/s (or m/s).

    ``units`` are those of slip speed and torque: of a slide m/s, and N of a friction force.

    A map has to be finite, its slip torque never negative (a clutch takes energy, it gives none),
    and its breakaway torque at least the slip torque at 0+. Each kind of failure is reported once,
    where it is worst. A map that asks for more than speed, excitation, direction and time is not
    judged here.
    """
    try:
        hash(law)
    except TypeError:  # a law of one's own with lists in it
        return _judged(law, full_scale, units)
    return list(_known(law, full_scale, units))


def least_breakaway(law: TorqueLaw, full_scale: float) -> float:
    """Least ratio of breakaway to slip torque at zero speed, from 0 V up; 1 where none is known."""
    try:
        slip, breakaway = _callables(law)
    except UnjudgedError:
        return 1.0
    volts = (full_scale * k / STEPS for k in range(1, STEPS + 1))
    return min((breakaway(v) / slip(v, 0.0) for v in volts if slip(v, 0.0) > 0.0), default=1.0)


def most_slip(law: TorqueLaw, full_scale: float) -> float:
    """Largest slip torque at zero speed up to ``full_scale`` [N m]; 0 where none is known."""
    try:
        slip, _ = _callables(law)
    except UnjudgedError:
        return 0.0
    return max(slip(full_scale * k / STEPS, 0.0) for k in range(STEPS + 1))


def _judged(law: TorqueLaw, full_scale: float, units: tuple[str, str]) -> list[LawFinding]:
    try:
        slip, breakaway = _callables(law)
    except UnjudgedError:
        return []

    def gap(v: float, _speed: float) -> float:
        return breakaway(v) - slip(v, 0.0)

    scale = 0.0
    grid = [full_scale * k / STEPS for k in range(STEPS + 1)]
    for v in grid:
        for speed in SPEEDS:
            for name, value in (("slip", _of(slip, v, speed)), ("break", _of(breakaway, v))):
                if not isinstance(value, float):
                    return [_broken(name, v, speed, value, units)]
                scale = max(scale, abs(value))
    found = []
    per, unit = units
    word = surface_word(unit)
    low, v, speed = _least(slip, grid, SPEEDS)
    if low < -1e-12 * scale:
        found.append(
            LawFinding(
                f"the slip {word} is negative",
                f"{_told(low, unit)} at {v:.6g} V and {speed:g} {per}",
                f"a slip {word} of at least 0 from 0 V to full scale, at all speeds",
            )
        )
    low, v, _ = _least(gap, grid, (0.0,))
    if low < -1e-12 * scale:
        found.append(
            LawFinding(
                f"the breakaway {word} is below the slip {word}",
                f"{_told(breakaway(v), unit)} < {_told(slip(v, 0.0), unit)} at {v:.6g} V",
                f"a breakaway {word} of at least the slip {word} at zero speed",
            )
        )
    return found


#: A map looked at once need not be again: thousands of scenarios may share it.
_known = functools.lru_cache(maxsize=256)(_judged)


class UnjudgedError(Exception):
    """A map that needs the state of a run."""


def _callables(law: TorqueLaw) -> tuple[Callable, Callable]:
    functions = law.functions()
    numbers = [*law.parameters().values(), *law.table()]
    base: dict[str, object] = {
        **law.parameters(), "p": numbers, "table_at": len(law.parameters()), "direction": 1.0,
        "time": 0.0, "t": 0.0,
    }  # fmt: skip

    def bound(name: str) -> Callable:
        function = functions[name]
        names = arguments_of(function)
        offered = {*base, "excitation", "effective", "speed", "slip"}
        if not set(names) <= offered:
            raise UnjudgedError

        def value(v: float, speed: float = 0.0) -> float:
            given = base | {"excitation": v, "effective": v, "speed": speed, "slip": speed}
            return function(**{n: given[n] for n in names})

        return value

    return bound("slip_torque"), bound("break_torque")


def _of(function: Callable, *arguments: float) -> object:
    try:
        value = float(function(*arguments))
    except Exception as error:  # whatever a user's law does
        return error
    return value if math.isfinite(value) else str(value)


def _broken(name: str, v: float, speed: float, value: object, units: tuple[str, str]) -> LawFinding:
    per, word = units[0], surface_word(units[1])
    failed = isinstance(value, Exception)
    what = f"fails ({type(value).__name__}: {value})" if failed else f"is {value}"
    return LawFinding(
        f"the {'slip' if name == 'slip' else 'breakaway'} {word} {what}",
        f"at {v:.6g} V and {speed:g} {per}",
        f"a finite {word} from 0 V to full scale, at all speeds",
    )


def _least(
    function: Callable[[float, float], float], grid: list[float], speeds: Iterable[float]
) -> tuple[float, float, float]:
    """Least value, and the excitation and speed where it is."""
    low, at, speed = min((function(v, s), v, s) for v in grid for s in speeds)
    width = grid[1] - grid[0]
    first, last = max(at - width, grid[0]), min(at + width, grid[-1])
    close = [first + (last - first) * k / STEPS for k in range(STEPS + 1)]
    return min((low, at, speed), *((function(v, speed), v, speed) for v in close))


def _told(value: float, unit: str) -> str:
    also = "lbf" if unit == "N" else "lbf*in"
    return f"{value:.6g} {unit.replace(' ', '*')} ({value / unit_size(also):.6g} {also})"
