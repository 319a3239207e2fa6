"""What 5.1 and 6.3 would change: time constant, materials, supply, actuator, torque control."""

from __future__ import annotations

from ..laws import TestbedTorque
from ..metrics import measures
from ..rigs.inputs import INCH, nominal
from ..rigs.line import line
from ..trajectory import Trajectory
from .rows import Engine, Row, claim
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
    return [*time_constants(engine), materials(engine), supply(), actuator(engine)]


def time_constants(engine: Engine) -> list[Row]:
    """S60: is the upper bound of the measured constants a worst case?"""
    rows = []
    for name, (kind, gain) in CONTROLLERS.items():
        found = {
            tau: summary(engine(line(kind, gain, nominal().replace(time_constant=tau))))
            for tau in (0.022, 0.05, 0.07, 0.124, 0.24)
        }
        error = {tau: e for tau, (e, _, _) in found.items()}
        rows.append(
            claim(
                "S60",
                f"0.07 s, the largest measured constant, is the worst of 0.022 to 0.07 s ({name})",
                "worst-case scenario",
                words({f"{tau:g} s": v for tau, v in found.items()}),
                error[0.07] >= max(error[0.022], error[0.05]),
            )
        )
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
        words(found),
        all(better),
        why="what steps the acceleration is the sign change of the slip torque; the gap to "
        "breakaway adds to it only where a clutch has stuck before",
        share=sum(better) / len(better),
    )


def supply() -> Row:
    """S68, S24: a supply with more voltage, by the closed form of a saturated coil."""
    found = {clamp: saturated(0.0, 8.0, clamp) for clamp in (12.0, 15.0, 30.0, 60.0)}
    text = ", ".join(
        f"{c / 10.0:g} x full scale: {1e3 * r.constant:.0f} ms" for c, r in found.items()
    )
    return claim(
        "S68",
        "a supply of higher voltage responds faster",
        "may improve",
        f"0 to 8 V torque constant for a clamp of {text}",
        found[30.0].constant < 0.6 * found[15.0].constant,
    )


def saturated(start: float, volts: float, clamp: float, inductive: float = 0.124) -> Response:
    """Torque response of a coil on a saturated supply: closed form, torque as excitation squared."""
    from math import exp, log, sqrt

    target = sqrt(start**2 + (1.0 - exp(-1.0)) * (volts**2 - start**2))
    return Response(0.0, inductive * log((clamp - start) / (clamp - target)))


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
        words(found),
        any(better),
        why="with the look-up table of the slow clutch; tracking improves where the claim holds",
        share=sum(better) / len(better),
    )
