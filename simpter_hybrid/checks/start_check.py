"""Whether a scenario's parts fit together, and give numbers where the run begins."""

from __future__ import annotations

import math
from typing import Any

from ..device_check import check_device
from ..kernel.linear import solve
from ..part import Part
from ..problems import KeyPath, Problems
from ..running.blame import failing_function, first_not_finite, held_not_finite, part_of
from ..scenario import Scenario
from .stage_check import check_stages


def clutch_path(problems: Problems, i: int) -> KeyPath:
    """Where a file describes clutch ``i``: ``[clutch]`` if that is for all."""
    own = ("clutches", i)
    return ("clutch",) if ("clutch",) in problems.places and own not in problems.places else own


def check_start(s: Scenario, problems: Problems) -> None:
    """The device is sound, and the model can be put together and evaluated where the run begins."""
    found = check_device(s.device, [s.q])
    for each in found:
        problems.add(("device",), f"{each.array}: {each.what}", each.value, each.right)
    if found:
        return None
    try:
        md = s.python_model()
        y, w = s.initial(lambda k: [0.0] * k, lambda k: [0] * k)
    except Exception as error:  # parts that do not fit, or a user's function that is no function
        what = f"the parts do not fit together ({error})"
        path = _path_in(str(error), s)
        return problems.add(path, what, _kind_at(path, s), "parts that fit the device")
    if check_stages(s, md, problems):
        return None

    def evaluate() -> None:
        md.terms(0.0, y, md.p, md.rec, w.held, w.mode, w.dmode, w.s, w.M, w.C, w.c, w.f, w.Q, w.fr)
        md.watch(0.0, y, md.p, md.rec, w.held, w.mode, w.dmode, w.s, w.g)
        md.control(0, 0.0, y, w.tau, md.p, md.rec, w.s, w.held, w.mem)

    try:
        function = first_not_finite(evaluate)
        what = "hands back a number that is not finite at the start"
        if function is None:
            y, w = s.initial(lambda k: [0.0] * k, lambda k: [0] * k)
            evaluate()
    except (Exception, SystemExit) as error:  # whatever a user's function does
        function = failing_function(error) or "device_function"
        what = f"fails at the start ({type(error).__name__}: {error})"
    if _too_heavy_rotors(s, problems, w):
        return None
    if function is not None:
        name, path = part_of(function) or ("model", ())
        kind = _kind_at(path, s)
        path = clutch_path(problems, int(path[1])) if path[:1] == ("clutches",) else path
        return problems.add(path, f"{name} {what}", kind, "finite numbers")
    if wrong := held_not_finite(s, w.held):
        what = f"at the first sample {wrong}"
        problems.add(("controller",), what, s.name, "finite numbers")
    _check_mass(s, problems, list(w.M))
    _check_dead_centres(s, problems, w)
    for k, stop in enumerate(s.stops):
        value = w.g[2 * md.m + k]
        if value < 0.0:
            reason = getattr(stop, "reason", type(stop).__name__)
            what = f"the run would end as it starts ({reason})"
            problems.add(_stop_path(k, problems), what, round(value, 9), "a start before it")


def _check_dead_centres(s: Scenario, problems: Problems, w: Any) -> None:
    """Nothing at rest begins where a row of the clutch map is zero: it would hold by nothing."""
    n = s.device.n
    for i in range(s.device.m):
        if w.c[i] == 0.0 and not any(w.C[i * n + j] for j in range(n)):
            what = f"clutch {i + 1} is at its dead centre, and nothing takes it past that"
            right = "a pose beside it, at which its row of the clutch map is not zero, or a speed"
            problems.add(("start", "coordinates"), what, [float(q) for q in s.q], right)


def _stop_path(k: int, problems: Problems) -> KeyPath:
    return ("stops", k) if ("stops", k) in problems.places else ("start",)


def _check_mass(s: Scenario, problems: Problems, M: list[float]) -> None:
    """What is added to a sound device's inertia leaves it positive definite at the start."""
    n = s.device.n
    adding: list[KeyPath] = [
        ("loads", k) for k, load in enumerate(s.loads) if "tip_inertia" in load.functions()
    ]
    adding += [("effects", k) for k, e in enumerate(s.effects) if "inertia" in e.functions()]
    for k in range(1, n + 1) if adding else ():
        block = [M[a * n + b] for a in range(k) for b in range(k)]
        if _determinant(block, k) <= 0.0:
            what = f"with it the mass matrix is not positive definite (leading block {k})"
            right = "inertias with positive kinetic energy for every motion"
            value = [round(v, 9) for v in M[: n * n]]
            return problems.add(adding[-1], what, value, right)


def _too_heavy_rotors(s: Scenario, problems: Problems, w: Any) -> bool:
    """Whether an effect has a rotor heavier than all that moves with it, which is a problem."""
    before = len(problems)
    for k, effect in enumerate(s.effects):
        rotor, whole = getattr(effect, "rotor", 0.0), w.M[0] / (w.C[0] * w.C[0] or math.inf)
        if s.device.n == s.device.m == 1 and rotor > whole > 0.0:
            right = f"at most {whole:.9g}, the inertia of all that moves with the clutch (SI)"
            problems.add(("effects", k, "rotor"), "more than the whole", rotor, right)
    return len(problems) > before


def _determinant(a: list[float], k: int) -> float:
    """Determinant of a small matrix, by its inverse's last entry (Cramer), recursively."""
    if k == 1:
        return a[0]
    unit = [0.0] * (k - 1) + [1.0]
    if solve(list(a), unit, k) != 0 or unit[-1] == 0.0:
        return 0.0
    block = [a[i * k + j] for i in range(k - 1) for j in range(k - 1)]
    return _determinant(block, k - 1) / unit[-1]


def _path_in(message: str, s: Scenario) -> KeyPath:
    """The part whose class a wiring error names."""
    lists: dict[str, Any] = {"loads": s.loads, "effects": s.effects, "stops": s.stops}
    for key, parts in lists.items():
        for k, part in enumerate(parts):
            if _names(message, part):
                return (key, k)
    for k, (stage, _) in enumerate(s.controllers):
        if _names(message, stage):
            return ("controller", "stages", k)
    return ("device",) if _names(message, s.device) else ()


def _kind_at(path: KeyPath, s: Scenario) -> str:
    """Class of the part at a path, or the scenario's name."""
    lists: dict[Any, Any] = {"loads": s.loads, "effects": s.effects, "stops": s.stops}
    if path and path[0] in lists and isinstance(path[1], int):
        return type(lists[path[0]][path[1]]).__name__
    if path[:2] == ("controller", "stages"):
        return type(s.controllers[int(path[2])][0]).__name__
    return type(s.device).__name__ if path[:1] == ("device",) else s.name


def _names(message: str, part: Part) -> bool:
    return f"{type(part).__name__}." in message or f"({type(part).__name__})" in message
