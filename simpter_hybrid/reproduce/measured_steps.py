"""Diagnosis of printed measurements: four step responses of torque against the declared lag."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from ..effects.coil_supply import CoilSupply
from ..effects.slew_limit import SlewLimit
from ..laws import LBF_IN, TestbedTorque
from .steps import PRINTED

#: From, to [V], delay and time constant [s]; the 0 to 6 V step's delay is not printed.
STEPS = tuple((start, volts, delay, constant) for _, _, start, volts, delay, constant in PRINTED)
#: Step of integration [s], and how long a response is followed.
STEP, SPAN = 5e-4, 0.5
#: The maker's time constant of the coil [s] and the loop gain that `CoilSupply` has by default.
COIL, STIFFNESS = 0.124, 20.0

Rate = Callable[[float, float], float]


@dataclass(frozen=True)
class Actuator:
    """Excitation's rate at (excitation, command), time from off to on, dead time before all."""

    rate: Rate
    closing: float
    dead: float = 0.0


@dataclass(frozen=True)
class Form:
    """A model of the actuator: name, parameters' starts, the actuator they make."""

    name: str
    starts: tuple[float, ...]
    make: Callable[[np.ndarray], Actuator]


def lag(constant: float) -> Rate:
    """The declared first-order lag on the command."""
    return lambda x, command: (command - x) / constant


def slewed(constant: float, slowness: float) -> Rate:
    """The lag with the rate's limit of `SlewLimit`."""
    own = SlewLimit.excitation_rate
    return lambda x, command: own((command - x) / constant, slowness, slowness)


def supplied(clamp: float) -> Rate:
    """Coil and current-controlled supply of `CoilSupply`."""
    own = CoilSupply.excitation_rate
    return lambda x, command: own(0.0, x, command, COIL, clamp, STIFFNESS)


DECLARED = Actuator(lag(0.07), 0.02)
FORMS = (
    Form("lag and gap refitted", (0.07, 0.02), lambda x: Actuator(lag(x[0]), x[1])),
    Form("and dead time", (0.04, 0.01, 0.01), lambda x: Actuator(lag(x[0]), x[1], x[2])),
    Form(
        "slew-limit and dead time", (0.015, 0.01, 0.01, 0.006),
        lambda x: Actuator(slewed(x[0], x[3]), x[1], x[2]),
    ),
    Form(
        "coil-supply and dead time", (15.0, 0.01, 0.01),
        lambda x: Actuator(supplied(x[0]), x[1], x[2]),
    ),
)  # fmt: skip


def response(actuator: Actuator, start: float, volts: float) -> tuple[float, float]:
    """Delay and time constant of torque, read as the thesis reads them [s].

    The delay ends at 0.1 % of the torque's change; the constant runs from there to 63.2 %.
    """
    time = np.arange(0.0, SPAN, STEP)
    excitation = np.empty(time.size)
    x = start
    for k in range(time.size):  # Heun's method
        excitation[k] = x
        first = actuator.rate(x, volts)
        x += 0.5 * STEP * (first + actuator.rate(x + STEP * first, volts))
    law = TestbedTorque()
    torque = ((law.a * excitation + law.b) * excitation + law.c) / LBF_IN
    change = (torque - torque[0]) / (torque[-1] - torque[0])
    begins, reaches = np.interp([0.001, 1.0 - math.exp(-1.0)], change, time)
    closing = actuator.closing if start == 0.0 else 0.0
    return float(actuator.dead + closing + begins), float(reaches - begins)


def errors(actuator: Actuator, which: Sequence[int] = range(4)) -> np.ndarray:
    """Predicted less printed delays and constants of some steps [s]."""
    found = []
    for i in which:
        start, volts, delay, constant = STEPS[i]
        ours = response(actuator, start, volts)
        if delay is not None:
            found.append(ours[0] - delay)
        found.append(ours[1] - constant)
    return np.array(found)


def fitted(form: Form, which: Sequence[int] = range(4)) -> np.ndarray:
    """Least squares over the printed numbers of some steps."""
    from scipy.optimize import least_squares

    starts = np.array(form.starts)
    found = least_squares(
        lambda x: 1e3 * errors(form.make(x), which), starts, x_scale=starts, diff_step=1e-3,
        bounds=(1e-5, np.inf), max_nfev=30,
    )  # fmt: skip
    return found.x


def left_out(form: Form) -> np.ndarray:
    """Errors on each step by a fit to the other three [s]."""
    found = [
        errors(form.make(fitted(form, [j for j in range(4) if j != i])), [i]) for i in range(4)
    ]
    return np.concatenate(found)


def rms(values: np.ndarray) -> float:
    """Root mean square."""
    return float(np.sqrt(np.mean(values**2)))
