"""Chapter 4's calibration arithmetic: equations (36)-(42)."""

from __future__ import annotations

import math

import numpy as np
from scipy import signal

from ..known_units import INCH
from .rows import Engine, Row, claim, number, uncomparable


def calibration(engine: Engine) -> list[Row]:
    """Equations (36), (38), (40)-(42) and the filter of 4.6, recomputed from what is printed."""
    return [*sensor_sheet(), *sensor_mass(), *gains(), *resonance(), *filtering()]


def sensor_sheet() -> list[Row]:
    """The torque sensor's own calibration (37)."""
    return [
        uncomparable(
            "A2",
            "fit of the sensor sheet (37), worst error 0.75 lb-in (Figure 14)",
            "681.139, 0.254",
            "not rebuilt",
            "the points of the sheet are lost",
        ),
    ]


def sensor_mass() -> list[Row]:
    """Whether the torque sensor is a spring without mass."""
    # 2 in of aluminium (0.0975 lbm/in^3), 1 1/32 in thick, against the coil's 11.6 lbm.
    ratio = 11.6 / (0.0975 * math.pi / 4.0 * 1.03125**2 * 2.0)
    # Rayleigh: a uniform spring counts as a third of its mass at its moving end.
    low = 1.0 - 1.0 / math.sqrt(1.0 + 1.0 / 3.0 / 45.0)
    return [
        uncomparable(
            "A5",
            "the coil's mass is about 45 times the sensor's",
            "about 45",
            f"{ratio:.0f} times a plain cylinder of the printed size",
            "the sensor's flanges, which add to its mass, are not described",
            ratio=ratio,
        ),
        claim(
            "A5",
            "so that the sensor may be taken as a massless spring",
            "valid",
            f"a third of its mass, moving with the coil, lowers the frequency by {100 * low:.1f} % "
            "at the printed ratio",
            low < 0.01,
            lowered=low,
        ),
    ]


def gains() -> list[Row]:
    """What a volt of the tachometer (36) and of the torque amplifier (38) means."""
    tachometer = 1000.0 / 3.0 / 20.0 / 60.0 * 2.0 * math.pi
    excitation = 681.139 / 171.988 * 1000.0 / 396.0
    return [
        number(
            "A1",
            "tachometer gain (36), 3 V per 1000 rpm and 20:1",
            1.7453,
            tachometer,
            "rad/s/V",
            relative=5e-5,
            digits=5,
        ),
        claim(
            "A3",
            "torque per volt (38) from (37) and the amplifier's 396",
            "171.988 lb-in/V",
            f"a bridge excitation of {excitation:.4f} V makes them agree",
            abs(excitation - 10.0) < 0.01,
            excitation=excitation,
        ),
    ]


def resonance() -> list[Row]:
    """The coil on the torque sensor as an oscillator (40)-(42)."""
    modulus, bore, length = 26e9, 0.0273, 0.0508
    stiffness = modulus * math.pi * bore**4 / 32.0 / length
    inertia = 0.5 * 5.262 * (0.1397**2 + 0.09525**2)
    frequency = math.sqrt(stiffness / inertia)
    thin = math.sqrt(modulus * math.pi * (1.03125 * INCH) ** 4 / 32.0 / length / inertia)
    return [
        number("A4", "sensor stiffness (40)", 27910.0, stiffness, "N m/rad", relative=1e-3),
        number("A4", "coil inertia (41)", 0.07522, inertia, "kg m^2", relative=1e-3),
        number("A4", "natural frequency (42)", 609.1, frequency, "rad/s", relative=1e-3),
        claim(
            "A4",
            "97 Hz explains an observed 90 Hz",
            "97 Hz, 90 Hz",
            f"{frequency / 2 / math.pi:.1f} Hz with the printed 0.0273 m; 1 1/32 in is 0.0262 m "
            f"and gives {thin / 2 / math.pi:.1f} Hz",
            abs(thin / 2 / math.pi - 90.0) < 2.0,
            why="(40) prints 0.0273 m for 1 1/32 in; with the diameter in the text the model "
            "meets the observation more closely than the thesis's own number",
            printed_diameter=frequency / 2 / math.pi,
            text_diameter=thin / 2 / math.pi,
        ),
    ]


def filtering() -> list[Row]:
    """What the filter of 4.6 delays."""
    delay = filter_delay(150.0, 4)
    return [
        claim(
            "A6",
            "delay of a causal 4th-order Butterworth filter at 150 Hz",
            "not printed",
            f"{1e3 * delay:.2f} ms at low frequency: small against the 20 ms delays, not against "
            "the 4 ms of Figure 21",
            delay < 4e-3,
            delay=delay,
        ),
    ]


def filter_delay(cutoff: float, order: int) -> float:
    """Low-frequency group delay of an analog Butterworth low-pass filter [s]."""
    b, a = signal.butter(order, 2.0 * math.pi * cutoff, analog=True)
    w = 2.0 * math.pi * cutoff * np.array([1e-4, 2e-4])
    _, response = signal.freqs(b, a, w)
    phase = np.unwrap(np.angle(response))
    return float(-(phase[1] - phase[0]) / (w[1] - w[0]))
