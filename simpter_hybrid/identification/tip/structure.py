"""Candidates that are neither friction nor actuator: inertia, lengths, what pulls, what reads."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, fields, replace
from functools import partial

from ...applied_load import Load
from ...effects.slew_limit import SlewLimit
from ...loads.tip_mass import TipMass
from ...loads.tip_spring import TipDrag, TipSpring
from ...scenario import Scenario
from ..fitting.predictor import Parameter
from ..rigs.declared_off import LAG, LAGS, TIME_CONSTANT, TORQUE_SCALE, scaled_numbers
from ..rigs.effect_candidate import EffectCandidate
from ..rigs.late_commands import late_commands

#: (name of a fit's parameter within its candidate, lower, upper, typical).
Field = tuple[str, float, float, float]
Shift = tuple[str, str, float]
#: SI units of these parameters by the last word of their names; of all others they are shares.
UNITS = {
    "push_x": "N", "push_y": "N", "stiffness": "N/m", "damping": "N*s/m", "mass": "kg",
    "angle": "rad", "offset": "rad", "delay": "s",
}  # fmt: skip

#: The experiment that shows a lag.
LAG_TEST = "Steps of the command up and down with one clutch slipping."


@dataclass(frozen=True)
class Scales:
    """Sizes taken from the record [SI]: tip force, speed and travel of the tip, a heavy mass there.

    The mass is one whose inertia is half the device's.
    """

    force: float
    speed: float
    travel: float
    mass: float


def structure_candidates(declared: Scenario, scales: Scales) -> tuple[EffectCandidate, ...]:
    """Candidates for a device with a tip beside friction, actuators and the joints' loads."""
    n, f = declared.device.n, scales.force
    k, d = f / scales.travel, f / scales.speed
    joints = [f"joint_{j + 1}:{c}" for j in range(n) for c in ("push", "push_across")]
    away = [f"joint_{j + 1}:{c}" for j in range(n) for c in ("position", "other_position")]
    push = (("push_x", -20 * f, 20 * f, 0.01 * f), ("push_y", -20 * f, 20 * f, 0.01 * f))
    moving = [f"joint_{j + 1}:{c}" for j in range(n) for c in ("slip_velocity", "speed")]
    gains = tuple((f"{j + 1}.gain", -0.3, 0.3, 0.005) for j in range(n))
    offsets = tuple((f"{j + 1}.offset", -0.5, 0.5, 0.01) for j in range(n))
    found = [
        # A constant tip force: gravity on what a tilted handle carries, or the sensor's offset.
        _pull("tilt", TipSpring(), push, "load by position", "load", [*away, *joints],
              "Turn the robot's base by a quarter."),
        _pull("tip-spring", TipSpring(), (("stiffness", -k, 5 * k, 0.01 * k), *push),
              "tip spring", "load", away, contains=("tilt", "force-offset")),
        _pull("tip-drag", TipDrag(), (("damping", -d, 5 * d, 0.01 * d),), "drag", "load", moving),
        _pull("force-offset", TipSpring(), push, "force offset", "sensor", joints,
              "Hold the tip still with all clutches on and read the force sensor unloaded."),
        _sensor("force-gain", (("x", -0.5, 1.0, 0.01), ("y", -0.5, 1.0, 0.01)), "force gain",
                joints, "Hang known weights on the handle along x and along y."),
        _sensor("force-turned", (("angle", -0.8, 0.8, 0.01),), "force direction", joints,
                "Pull along x and along y with a string."),
        _sensor("force-crosstalk", (("x", -0.4, 0.4, 0.01), ("y", -0.4, 0.4, 0.01)),
                "force direction", joints, "Pull along x and along y with a string.",
                contains=("force-turned",)),
        _sensor("force-delay", (("delay", -0.02, 0.1, 0.002),), "force delay",
                [f"joint_{j + 1}:push_rate" for j in range(n)],
                "Tap the handle with all clutches off."),
        _sensor("angle-offset", offsets, "angle sensors", joints,
                "Move the tip to points of known place."),
        _sensor("angle-gain", (*gains, *offsets), "angle sensors", [*joints, *away],
                "Move the tip to several points of known place."),
    ]  # fmt: skip
    return (*found, *_declared(declared, joints, scales.mass))


def _declared(declared: Scenario, joints: Sequence[str], heavy: float) -> list[EffectCandidate]:
    """A mass at the tip, and declared numbers set free: inertia, lengths, time constants."""
    device, m = declared.device, declared.device.m
    known = device.parameters()
    where = [f"joint_{j + 1}:{c}" for j in range(device.n)
             for c in ("acceleration", "other_acceleration", "push")]  # fmt: skip
    told = ("excitation", "excitation_rate", "excitation_branch", "torque")
    switching = [f"joint_{j + 1}:{c}" for j in range(device.n) for c in told]
    kinds = {x.name: x.metadata.get("dimension") for x in fields(device)}
    size = max((abs(known[k]) for k in known if kinds[k] == "inertia"), default=0.0)
    found = []
    if "tip_jacobian_rate" in device.functions():
        mass = (("mass", -heavy, 2 * heavy, 0.01 * heavy),)
        test = "Hard acceleration with and without what is on the handle."
        found.append(_pull("payload", TipMass(), mass, "inertia", "load", where, test))
    inertia = [k for k in known if kinds[k] == "inertia"]
    if inertia:
        given = tuple((k, -0.6 * size, 2 * size, 0.01 * size) for k in inertia)
        shifts = tuple((f"inertia.{k}", f"device.{k}", 1.0) for k in inertia)
        freed = _freed("inertia", given, shifts, "inertia", "load", where,
                       "Hard acceleration with all clutches off.")  # fmt: skip
        named = tuple(replace(p, unit="kg*m^2") for p in freed.parameters)
        found.append(replace(freed, parameters=named))
    lengths = [k for k in known if kinds[k] == "length"]
    if lengths:
        given = tuple((k, -0.3, 0.5, 0.005) for k in lengths)
        shifts = tuple((f"link-lengths.{k}", f"device.{k}", known[k]) for k in lengths)
        found.append(_freed("link-lengths", given, shifts, "lengths", "load", joints,
                            "Measure the links."))  # fmt: skip
    tau = [c.time_constant for c in declared.clutches]
    found += time_constants(declared, range(m), switching)
    found.append(_supply(m, tau, switching, LAG_TEST))
    found.append(late_commands(declared, range(m), switching, LAG_TEST))
    return [*found, *torque_scales(declared, [*switching, *joints])]


def time_constants(
    declared: Scenario, clutches: Collection[int], where: Sequence[str]
) -> Iterator[EffectCandidate]:
    """Candidates: lags of these clutches (from 0) off their declared ones."""
    numbers = [[f"clutch.{i + 1}.time_constant"] for i in range(declared.device.m)]
    lag = partial(_freed, family=LAG, acts_on="actuator", where=where, test=LAG_TEST)
    for candidate in _of_clutches(TIME_CONSTANT, numbers, LAGS, lag):
        if len(clutches) == len(numbers):
            yield candidate
        elif clutches and candidate.places:
            own = candidate.only([str(i + 1) for i in clutches])
            yield replace(own, plain="")


def torque_scales(declared: Scenario, where: Sequence[str]) -> Iterator[EffectCandidate]:
    """Candidates: clutches off their declared torque; none if one's torque cannot be scaled."""
    numbers = [scaled_numbers(declared, i) for i in range(declared.device.m)]
    if all(numbers):
        test = "Pull against one engaged clutch after the other."
        scale = partial(_freed, family=TORQUE_SCALE, acts_on="friction", where=where, test=test)
        yield from _of_clutches(TORQUE_SCALE, numbers, (-0.9, 2.0, 0.02), scale)


def _of_clutches(
    name: str, numbers: Sequence[Iterable[str]], bounds: tuple[float, float, float], freed
) -> Iterator[EffectCandidate]:
    """Declared numbers of the clutches set free, off by one share for all or by one for each."""
    for called, one in ((name, False), (f"{name} by clutch", True)):
        own = [f"{i + 1}.share" if one else "share" for i in range(len(numbers))]
        given = tuple((x, *bounds) for x in dict.fromkeys(own))
        shares = tuple(
            (f"{called}.{own[i]}", number) for i, some in enumerate(numbers) for number in some
        )
        yield replace(freed(called, given, ()), shares=shares, plain=name if one else "")


def _supply(m: int, tau: Sequence[float], where: Sequence[str], test: str) -> EffectCandidate:
    """Candidate: a supply that limits the excitation's slew, with coils quicker than declared.

    The declared lag may include what the supply does: beside a slew limit it is another one.
    """
    name, share = "slew-limit-2", "time constant.share"
    both = tuple(Parameter(f"{name}.{k}", 0.0, 0.0, 0.2, 0.002, unit="s/V")
                 for k in ("slowness", "slowness_down"))  # fmt: skip
    effects = tuple(SlewLimit(clutch=i) for i in range(m))
    return EffectCandidate(
        name, (*both, Parameter(share, 0.0, -0.9, 3.0, 0.03)), ((0.012, 0.012, -0.4),),
        SlewLimit.family, SlewLimit.acts_on, tuple(where), test, effects[0], effects[1:],
        shifts=tuple((share, f"clutch.{i + 1}.time_constant", tau[i]) for i in range(m)),
        contains=("slew-limit", TIME_CONSTANT),
    )  # fmt: skip


def _pull(name: str, load: Load, given: Sequence[Field], family, acts_on, where, test="", **more):
    own = _parameters(name, given)
    test = test or "Move the tip slowly over the whole range with all clutches off."
    return EffectCandidate(
        name, own, ((0.0,) * len(own),), family, acts_on, tuple(where), test, load=load, **more
    )


def _sensor(
    name: str, given: Sequence[Field], family: str, where: Sequence[str], test: str, **more
) -> EffectCandidate:
    own = _parameters(name, given)
    zeros = ((0.0,) * len(own),)
    return EffectCandidate(name, own, zeros, family, "sensor", tuple(where), test, **more)


def _freed(name: str, given, shifts: tuple[Shift, ...], family, acts_on, where, test: str):
    own = _parameters(name, given)
    zeros = ((0.0,) * len(own),)
    return EffectCandidate(
        name, own, zeros, family, acts_on, tuple(where), test, shifts=shifts
    )  # fmt: skip


def _parameters(name: str, given: Sequence[Field]) -> tuple[Parameter, ...]:
    return tuple(
        Parameter(f"{name}.{own}", 0.0, low, high, size, unit=UNITS.get(own.rpartition(".")[2], ""))
        for own, low, high, size in given
    )
