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
#: What a direction changes in a map shows in these of what it may ask for.
SIGNED = {"direction", "slip"}


class LawFinding(NamedTuple):
    """What is wrong with a torque map: what, where with which values, what would be right."""

    what: str
    value: str
    right: str


def check_law(
    law: TorqueLaw, full_scale: float, units: tuple[str, str] = ("rad/s", "N m")
) -> list[LawFinding]:
    """Findings about a map from 0 V to ``full_scale`` [V], at up to 20 rad/s (or m/s) both ways.

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

    def gap(v: float, slow: float) -> float:
        return breakaway(v, slow) - slip(v, slow)

    asked = {name for function in law.functions().values() for name in arguments_of(function)}
    ways = (1.0, -1.0) if asked & SIGNED - set(law.parameters()) else (1.0,)
    slips = [math.copysign(speed, way) for way in ways for speed in SPEEDS]
    slow = [math.copysign(0.0, way) for way in ways]
    scale = 0.0
    grid = [full_scale * k / STEPS for k in range(STEPS + 1)]
    for v in grid:
        for w in slips:
            at_rest = math.copysign(0.0, w)
            for name, value in (("slip", _of(slip, v, w)), ("break", _of(breakaway, v, at_rest))):
                if not isinstance(value, float):
                    return [_broken(name, v, w, value, units)]
                scale = max(scale, abs(value))
    found = []
    per, unit = units
    word = surface_word(unit)
    low, v, w = _least(slip, grid, slips)
    if low < -1e-12 * scale:
        found.append(
            LawFinding(
                f"the slip {word} is negative",
                f"{_told(low, unit)} at {v:.6g} V and {abs(w):g} {per}{_way(w)}",
                f"a slip {word} of at least 0 from 0 V to full scale, at all speeds",
            )
        )
    low, v, w = _least(gap, grid, slow)
    if low < -1e-12 * scale:
        found.append(
            LawFinding(
                f"the breakaway {word} is below the slip {word}",
                f"{_told(breakaway(v, w), unit)} < {_told(slip(v, w), unit)} at {v:.6g} V{_way(w)}",
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
        **law.parameters(), "p": numbers, "table_at": len(law.parameters()), "time": 0.0, "t": 0.0,
    }  # fmt: skip

    def bound(name: str) -> Callable:
        function = functions[name]
        names = arguments_of(function)
        offered = {*base, "excitation", "effective", "speed", *SIGNED}
        if not set(names) <= offered:
            raise UnjudgedError

        def value(v: float, w: float = 0.0) -> float:
            way = math.copysign(1.0, w)  # at rest the one it would go
            signals = {"effective": v, "speed": abs(w), "slip": w, "direction": way}
            given = signals | base | {"excitation": v}  # as in a run: numbers before signals
            return function(**{n: given[n] for n in names})

        return value

    return bound("slip_torque"), bound("break_torque")


def _of(function: Callable, *arguments: float) -> object:
    try:
        value = float(function(*arguments))
    except Exception as error:  # whatever a user's law does
        return error
    return value if math.isfinite(value) else str(value)


def _way(w: float) -> str:
    return " backwards" if math.copysign(1.0, w) < 0.0 else ""


def _broken(name: str, v: float, w: float, value: object, units: tuple[str, str]) -> LawFinding:
    per, word = units[0], surface_word(units[1])
    failed = isinstance(value, Exception)
    what = f"fails ({type(value).__name__}: {value})" if failed else f"is {value}"
    return LawFinding(
        f"the {'slip' if name == 'slip' else 'breakaway'} {word} {what}",
        f"at {v:.6g} V and {abs(w):g} {per}{_way(w)}",
        f"a finite {word} from 0 V to full scale, at all speeds",
    )


def _least(
    function: Callable[[float, float], float], grid: list[float], slips: Iterable[float]
) -> tuple[float, float, float]:
    """Least value, and the excitation and slip velocity where it is; forward if both ways."""

    def least(found: tuple[float, float, float]) -> tuple[float, float, bool]:
        return found[0], found[1], bool(_way(found[2]))

    low, at, w = min(((function(v, s), v, s) for v in grid for s in slips), key=least)
    width = grid[1] - grid[0]
    first, last = max(at - width, grid[0]), min(at + width, grid[-1])
    close = [first + (last - first) * k / STEPS for k in range(STEPS + 1)]
    return min((low, at, w), *((function(v, w), v, w) for v in close), key=least)


def _told(value: float, unit: str) -> str:
    also = "lbf" if unit == "N" else "lbf*in"
    return f"{value:.6g} {unit.replace(' ', '*')} ({value / unit_size(also):.6g} {also})"
