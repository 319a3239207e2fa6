"""What 5.1 and 6.3 would change: time constant, materials, supply, actuator, torque control."""

from __future__ import annotations

from math import exp, log, sqrt

import numpy as np

from ..controllers.integral_feedback import IntegralFeedback
from ..controllers.inverse_model import InverseModel
from ..controllers.torque_feedback import TorqueFeedback
from ..known_units import INCH
from ..laws import LBF_IN, TestbedTorque
from ..measuring.metrics import measures
from ..measuring.sampling import sample
from ..rigs.inputs import nominal
from ..rigs.line import line
from ..rigs.regulation import regulation
from ..trajectory import Trajectory
from .rows import Engine, Row, claim, uncomparable
from .standard import CONTROLLERS
from .steps import Response


def summary(trajectory: Trajectory) -> tuple[float, float, int]:
    """Average error [in], variation of acceleration [in/s^3] and transitions."""
    m = measures(trajectory, 2e-3)
    return (
        m.average_error / INCH,
        (m.variation_smooth + m.variation_jumps) / INCH,
        m.transitions,
    )


def words(found: dict[str, tuple[float, float, int]]) -> str:
    """Results of several runs in a line."""
    return "; ".join(
        f"{name}: error {e:.3f} in, variation {v:.0f} in/s^3, {n} transitions"
        for name, (e, v, n) in found.items()
    )


def variants(engine: Engine) -> list[Row]:
    """S60, S67, S68, S72, S73."""
    return [
        *time_constants(engine),
        materials(engine),
        supply(),
        fast_mode(),
        actuator(engine),
        torque_control(engine),
    ]


def time_constants(engine: Engine) -> list[Row]:
    """S60: is the upper bound of the measured constants a worst case?"""
    rows = []
    for name, (kind, gain) in CONTROLLERS.items():
        found = {
            tau: summary(engine(line(kind, gain, nominal().replace(time_constant=tau))))
            for tau in (0.022, 0.05, 0.07, 0.124, 0.24)
        }
        best = {tau: found[tau] for tau in (0.022, 0.05, 0.07)}
        every = words({f"{tau:g} s": v for tau, v in found.items()})
        rows += [
            claim(
                "S60",
                f"0.07 s is the worst of 0.022 to 0.07 s for tracking ({name})",
                "worst-case scenario",
                every,
                found[0.07][0] >= max(e for e, _, _ in best.values()),
            ),
            claim(
                "S60",
                f"and for smoothness ({name})",
                "worst-case scenario",
                every,
                found[0.07][1] >= max(v for _, v, _ in best.values()),
                why="a faster clutch lowers the gain at which the sampled torque loop loses its "
                "stability: 0.16 at 150 Hz is stable at 0.07 s and not at 0.022 s"
                if gain
                else "",
            ),
        ]
    return rows


def materials(engine: Engine) -> Row:
    """S67: a pair whose breakaway equals its slip torque at zero speed (Delrin on steel)."""
    t = TestbedTorque()
    even = TestbedTorque(d=t.offset * t.a, e=t.offset * t.b, f=t.offset * t.c)
    found, better = {}, []
    for name, (kind, gain) in CONTROLLERS.items():
        for law, label in ((t, "steel"), (even, "even")):
            found[f"{name}, {label}"] = summary(engine(line(kind, gain, law=law)))
        better.append(found[f"{name}, even"][1] < found[f"{name}, steel"][1])
    return claim(
        "S67",
        "an equal breakaway and slip torque makes the device smoother",
        "hypothesized",
        f"smoother with {sum(better)} of {len(better)} controllers: {words(found)}",
        all(better),
        why="what steps the acceleration is the sign change of the slip torque; the gap to "
        "breakaway adds to it only where a clutch has stuck before",
    )


def supply() -> Row:
    """S68, S24: a supply with more voltage, by the closed form of a saturated coil."""
    found = {clamp: saturated(0.0, 8.0, clamp) for clamp in (12.0, 15.0, 30.0, 60.0)}
    text = ", ".join(
        f"{c / 10.0:g} x full scale: {1e3 * r.constant:.0f} ms" for c, r in found.items()
    )
    return claim(
        "S68 S24",
        "a supply of higher voltage responds faster",
        "may improve",
        f"0 to 8 V torque constant for a clamp of {text}",
        found[30.0].constant < 0.6 * found[15.0].constant,
    )


def saturated(start: float, volts: float, clamp: float, inductive: float = 0.124) -> Response:
    """Torque response of a coil on a saturated supply: closed form, torque as current squared."""
    target = sqrt(start**2 + (1.0 - exp(-1.0)) * (volts**2 - start**2))
    return Response(0.0, inductive * log((clamp - start) / (clamp - target)))


def fast_mode() -> Row:
    """S69: the supplies' fast mode."""
    return uncomparable(
        "S69",
        "the supplies' fast mode improves the transient response",
        "may improve",
        "a stiffer current loop cannot outrun a saturated voltage: see the supply of higher "
        "voltage",
        "what the mode changes inside the supply is not printed",
    )


def torque_control(engine: Engine) -> Row:
    """S73: integral and model-based torque control of one clutch at 150 Hz (Figure 50's task)."""
    rig = regulation(0.0, 150.0, t_end=1.5)
    selector, table = (stage for stage, _ in rig.controllers[:2])
    stages = {
        "table": (selector, table),
        "feedback 0.25": (selector, table, TorqueFeedback(0.25 / LBF_IN)),
        "feedback 0.1 and integral": (
            selector,
            table,
            TorqueFeedback(0.1 / LBF_IN),
            IntegralFeedback(1.0 / LBF_IN),
        ),
        "inverse of (39)": (selector, InverseModel()),
    }
    error = {}
    for name, parts in stages.items():
        run = engine(rig.replace(controllers=tuple((part, 1) for part in parts)))
        torque = np.abs(sample(run, np.linspace(1.2, 1.49, 30)).tau[:, 0]) / LBF_IN
        error[name] = float(np.abs(torque - 150.0).max())
    return claim(
        "S73",
        "an integral or a model removes the steady error that proportional feedback leaves",
        "implied",
        "; ".join(f"{n}: {e:.2f} lb-in" for n, e in error.items()),
        max(error["feedback 0.1 and integral"], error["inverse of (39)"])
        < 0.5 * error["feedback 0.25"],
    )


def actuator(engine: Engine) -> Row:
    """S72: a fast brake without gap or breakaway (magnetorheological, say) in the same device."""
    t = TestbedTorque()
    even = TestbedTorque(d=t.offset * t.a, e=t.offset * t.b, f=t.offset * t.c)
    fast = nominal().replace(time_constant=0.01, delay=0.0)
    found, better = {}, []
    for name, (kind, gain) in CONTROLLERS.items():
        found[f"{name}, clutch"] = summary(engine(line(kind, gain)))
        found[f"{name}, fast brake"] = summary(engine(line(kind, gain, fast, law=even)))
        better.append(found[f"{name}, fast brake"][0] < found[f"{name}, clutch"][0])
    return claim(
        "S72",
        "another type of clutch can be judged by exchanging the actuator model",
        "may serve",
        f"tracking improves with {sum(better)} of {len(better)} controllers: {words(found)}",
        any(better),
        why="with the look-up table of the slow clutch; the claim holds where any tracks better",
    )
