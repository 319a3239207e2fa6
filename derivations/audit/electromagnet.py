"""Equations (31)-(35): why the clutch torque grows with the square of the current."""

from __future__ import annotations

import sympy as sp

from derivations.audit.compare import same
from derivations.audit.verdict import Entry

T = sp.Symbol("t", positive=True)
X, CURRENT, R, MU = sp.symbols("x i R mu", positive=True)
L_CONSTANT = sp.Symbol("L", positive=True)
INDUCTANCE = sp.Function("L", positive=True)(X)


def _energy_is_integral_of_power() -> bool:
    voltage, current = sp.Function("V")(T), sp.Function("i")(T)
    upper = sp.Symbol("T", positive=True)
    energy = sp.Integral(voltage * current, (T, 0, upper))
    return same(energy.diff(upper), (voltage * current).subs(T, upper))


def _stored(resistance: sp.Expr) -> bool:
    """Energy supplied while the current rises from zero, for a ramp, against L i^2 / 2."""
    rate = sp.Symbol("c", positive=True)
    current = rate * T
    voltage = L_CONSTANT * current.diff(T) + resistance * current
    supplied = sp.integrate(voltage * current, (T, 0, CURRENT / rate))
    return same(supplied, L_CONSTANT * CURRENT**2 / 2)


def _work_is_energy_gain(constant: str) -> bool:
    """N dx = dE for a virtual displacement at constant current or constant flux linkage."""
    force = _force_from_energy_balance()
    if constant == "current":
        gain = (INDUCTANCE * CURRENT**2 / 2).diff(X)
    else:
        flux = sp.Symbol("lambda", positive=True)
        gain = (flux**2 / (2 * INDUCTANCE)).diff(X).subs(flux, INDUCTANCE * CURRENT)
    return same(force, gain)


def _force_from_energy_balance() -> sp.Expr:
    """Source work i d(lambda) = dE + N dx at constant current, solved for N."""
    source = CURRENT * (INDUCTANCE * CURRENT).diff(X)
    stored = (INDUCTANCE * CURRENT**2 / 2).diff(X)
    return source - stored


def _force_does_not_depend_on_what_is_held() -> bool:
    flux = sp.Symbol("lambda", positive=True)
    at_constant_flux = -(flux**2 / (2 * INDUCTANCE)).diff(X).subs(flux, INDUCTANCE * CURRENT)
    printed = CURRENT**2 * INDUCTANCE.diff(X) / 2
    return same(printed, at_constant_flux) and same(printed, _force_from_energy_balance())


def _friction_grows_with_the_square() -> bool:
    friction = MU * CURRENT**2 * INDUCTANCE.diff(X) / 2
    return same(friction.subs(CURRENT, 2 * CURRENT), 4 * friction)


def entries() -> list[Entry]:
    """Entries of equations (31)-(35)."""
    return [
        Entry("31", "energy supplied to the coil", "symbolically: its rate is the power V i",
              _energy_is_integral_of_power),
        Entry(
            "32", "energy stored in the coil", "symbolically, for a ramp of current",
            lambda: _stored(R), "integral signs",
            condition="R = 0 and L constant: the stored part of (31), the heat R i^2 left out",
            conditional=lambda: _stored(sp.Integer(0)),
        ),
        Entry(
            "33", "virtual work equals energy gain", "symbolically, at constant current and flux",
            lambda: _work_is_energy_gain("current") and _work_is_energy_gain("flux"),
            condition="constant current (the source supplies as much again); at constant flux "
            "the sign is the opposite",
            conditional=lambda: _work_is_energy_gain("current")
            and not _work_is_energy_gain("flux"),
            remark="the thesis states the condition one line further on",
        ),
        Entry(
            "34", "normal force N = i^2 dL/dx / 2",
            "symbolically: energy balance at constant current and at constant flux",
            _force_does_not_depend_on_what_is_held,
            remark="L falls as the gap x grows, so the force closes the gap",
        ),
        Entry("35", "F = mu N", "symbolically with (34): twice the current, four times the force",
              _friction_grows_with_the_square),
    ]  # fmt: skip
