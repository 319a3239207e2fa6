"""Equations (36)-(38) and (40)-(42): calibration factors and the ring of the torque sensor."""

from __future__ import annotations

import math

import sympy as sp

from derivations.audit.compare import rounds_to, same
from derivations.audit.verdict import Entry

INCH, POUND = 0.0254, 0.45359237
SLOPE_37, SLOPE_38, OFFSET_37, OFFSET_38, AMPLIFIER = 681.139, 171.988, 0.254, 0.254, 396.0
SHEAR_MODULUS, LENGTH = 26e9, 0.0508
PRINTED_STIFFNESS, PRINTED_INERTIA, OBSERVED_HZ = 27910.0, 0.07522, 90.0


def tachometer_gain() -> float:
    """(36) [rad/s per V]: 3 V per 1000 rpm behind a 20:1 gearbox."""
    return 1000.0 / 3.0 / 20.0 / 60.0 * 2.0 * math.pi


def bridge_excitation() -> float:
    """Excitation [V] that takes (37), per mV/V, into (38), per V behind the amplifier."""
    return SLOPE_37 / SLOPE_38 / AMPLIFIER * 1000.0


def _slope_38(excitation: float) -> float:
    return SLOPE_37 / (excitation * AMPLIFIER / 1000.0)


def stiffness(diameter: float) -> float:
    """(40) [N m/rad] of a solid cylinder of this diameter [m]."""
    return SHEAR_MODULUS * math.pi * diameter**4 / 32.0 / LENGTH


def _no_fraction_of_an_inch_is(printed: str) -> bool:
    """Whether no diameter of 1 n/d inch (d = 8 ... 64) rounds to the printed metres."""
    return not any(
        rounds_to((1.0 + n / d) * INCH, printed) for d in (8, 16, 32, 64) for n in range(d)
    )


def frequency(torsional_stiffness: float) -> float:
    """(42) [rad/s]."""
    return math.sqrt(torsional_stiffness / PRINTED_INERTIA)


TEXT_DIAMETER = (1.0 + 1.0 / 32.0) * INCH


def _inertia_formula() -> bool:
    """(41): integral of r^2 dm over an annulus of uniform thickness, and its numbers."""
    r, inner, outer, mass = sp.symbols("r R_i R_o m", positive=True)
    density = mass / (sp.pi * (outer**2 - inner**2))
    integral = sp.integrate(density * 2 * sp.pi * r**3, (r, inner, outer))
    formula = same(sp.factor(integral), mass * (inner**2 + outer**2) / 2)
    numbers = (
        rounds_to(11.6 * POUND, "5.262")
        and rounds_to(5.5 * INCH, "0.1397")
        and rounds_to(3.75 * INCH, "0.09525")
        and rounds_to(0.5 * 5.262 * (0.1397**2 + 0.09525**2), "0.07522")
    )
    return formula and numbers


def _corrected_stiffness() -> bool:
    """The text's diameter: 0.0262 m, and a ring nearer to the observed one than the printed."""
    corrected = frequency(stiffness(TEXT_DIAMETER)) / (2 * math.pi)
    printed = frequency(PRINTED_STIFFNESS) / (2 * math.pi)
    return (
        rounds_to(TEXT_DIAMETER, "0.0262")
        and rounds_to(stiffness(TEXT_DIAMETER) / 10.0, "2365")
        and rounds_to(corrected, "89.2")
        and abs(corrected - OBSERVED_HZ) < abs(printed - OBSERVED_HZ)
        and rounds_to(stiffness(0.0273) / 10.0, "2791")
        and _no_fraction_of_an_inch_is("0.0273")
    )


def _ring(root: bool) -> bool:
    ratio = PRINTED_STIFFNESS / PRINTED_INERTIA
    omega = math.sqrt(ratio) if root else ratio
    return rounds_to(omega, "609.1") and rounds_to(omega / (2 * math.pi), "97")


def entries() -> list[Entry]:
    """Entries of equations (36)-(38) and (40)-(42)."""
    return [
        Entry("36", "tachometer gain", "its own numbers",
              lambda: rounds_to(tachometer_gain(), "1.7453")),
        Entry(
            "37", "torque sensor, lb-in per mV/V",
            "against (38): same offset, bridge excitation within 0.1 % of 10 V; the calibration "
            "sheet is not available",
            lambda: OFFSET_37 == OFFSET_38 and abs(bridge_excitation() / 10.0 - 1.0) < 1e-3,
        ),
        Entry(
            "38", "torque sensor, lb-in per V", "from (37), gain 396, excitation of 10 V",
            lambda: rounds_to(_slope_38(10.0), "171.988"),
            condition="bridge excitation of 10.001 V, which is not printed (10 V gives 172.005)",
            conditional=lambda: rounds_to(_slope_38(10.001), "171.988")
            and rounds_to(_slope_38(10.0), "172.005"),
        ),
        Entry(
            "40", "torsional stiffness of the sensor", "its own numbers and those of the text",
            lambda: rounds_to(stiffness(TEXT_DIAMETER) / 10.0, "2791"),
            corrected="diameter 1 1/32 in = 0.0262 m, k = 23 650 N m; (42) is then 89.2 Hz",
            correction=_corrected_stiffness,
            remark="the printed 0.0273 m gives the printed 27 910 N m but is not 1 1/32 in, nor "
            "any 1 n/64 in; 26E109 is 26e9, N m is N/m^2; the corrected ring is nearer to the "
            "observed 90 Hz",
        ),
        Entry(
            "41", "moment of inertia of the coil", "symbolically (integral), and its own numbers",
            _inertia_formula, remark="the numbers of inner and outer radius are exchanged, "
            "which changes nothing",
        ),
        Entry(
            "42", "natural frequency of coil on sensor", "its own numbers",
            lambda: _ring(root=False), "root", lambda: _ring(root=True),
            remark="with the corrected (40): 560.8 rad/s, 89.2 Hz",
        ),
    ]  # fmt: skip
