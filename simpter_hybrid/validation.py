"""What is wrong with a scenario, found before it runs, all at once."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

from .blame import failing_function, first_not_finite, held_not_finite, part_of
from .device_check import check_device
from .kernel.linear import solve
from .law_check import check_law
from .part import Part
from .problems import KeyPath, Problems
from .scenario import Scenario

#: Steps or samples of one run that still fit in memory.
MOST_STEPS = 2e7


def check_scenario(scenario: Scenario, problems: Problems) -> None:
    """Record everything that is wrong with a scenario.

    Paths are those of a scenario file, so that a file's problems get their lines.

    Parameters
    ----------
    scenario : Scenario
    problems : Problems
        For a scenario made in Python: ``Problems("Scenario('name')")``.
    """
    before = len(problems)
    _check_run(scenario, problems)
    _check_clutches(scenario, problems)
    _check_laws(scenario, problems)
    _check_stages(scenario, problems)
    _check_records(scenario, problems)
    if len(problems) == before:
        _check_start(scenario, problems)


def validate(scenario: Scenario) -> None:
    """Raise InvalidInput with everything that is wrong with a scenario made in Python."""
    problems = Problems(f"Scenario({scenario.name!r})")
    check_scenario(scenario, problems)
    problems.raise_if_any()


def clutch_path(problems: Problems, i: int) -> KeyPath:
    """Where a file describes clutch ``i``: ``[clutch]`` if it is one for all."""
    return ("clutch",) if ("clutch",) in problems.places else ("clutches", i)


def _check_run(s: Scenario, problems: Problems) -> None:
    n, m = s.device.n, s.device.m
    names = ", ".join(s.device.coordinates)
    for key, values in (("coordinates", s.q), ("speeds", s.qd)):
        if len(values) != n:
            problems.add(("start", key), "wrong number", len(values), f"{n}, one each for {names}")
        elif not all(math.isfinite(v) for v in values):
            problems.add(("start", key), "not finite", values, "finite numbers")
    if len(s.clutches) != m:
        right = f"{m}, one each for {', '.join(s.device.surfaces)}"
        problems.add(("clutches",), "wrong number of clutches", len(s.clutches), right)
    for key, values in (("commands", s.command), ("excitations", s.excitation)):
        if values and len(values) != m:
            problems.add(("start", key), "wrong number", len(values), f"{m}, one a clutch")
    limits = (
        ("t_end", s.t_end, 0.0, 1e7), ("max_step", s.max_step, 0.0, math.inf),
        ("rtol", s.rtol, 1e-14, 0.1), ("atol", s.atol, 0.0, 0.1),
        ("event_limit", s.event_limit, 0, math.inf),
    )  # fmt: skip
    for key, value, low, high in limits:
        if not low < value <= high:
            top = f" and at most {high:g}" if math.isfinite(high) else ""
            problems.add(("run", key), "out of range", value, f"above {low:g}{top} (SI)")
    if s.max_step > 0.0 and MOST_STEPS < s.t_end / s.max_step < math.inf:
        what, right = "too many steps", f"a max_step of at least t_end/{MOST_STEPS:.0e}"
        problems.add(("run", "max_step"), what, f"{s.t_end / s.max_step:.3g}", right)
    if not (math.isfinite(s.period) and s.period >= 0.0):
        problems.add(("controller", "period"), "not a period", s.period, "at least 0 s, finite")
    elif s.period > 0.0 and s.t_end / s.period > MOST_STEPS:
        what, right = "too many samples", f"at most {MOST_STEPS:.0e} within t_end"
        problems.add(("controller",), what, f"{s.t_end / s.period:.3g}", right)
    elif s.controllers and s.period == 0.0:
        problems.add(("controller", "period"), "no period, but controllers", 0.0, "above 0 s")


def _check_clutches(s: Scenario, problems: Problems) -> None:
    seen = set()
    for i, clutch in enumerate(s.clutches):
        path = clutch_path(problems, i)
        full = clutch.full_scale
        for key, values in (("commands", s.command), ("excitations", s.excitation)):
            if i < len(values) and not 0.0 <= values[i] <= full:
                right = f"from 0 V to clutch {i + 1}'s full scale, {full:g} V"
                what, value = "outside the clutch's range", f"{values[i]:g} V"
                problems.add(("start", key, i), what, value, right)
        if path in seen:
            continue
        seen.add(path)
        for name, low in (("time_constant", 0.0), ("delay", 0.0), ("full_scale", 1e-300)):
            value = getattr(clutch, name)
            if not low <= value < math.inf:
                problems.add((*path, name), "out of range", value, "finite, not negative (SI)")
        if not clutch.threshold < full:
            right, value = f"a threshold below full_scale, {full:g} V", f"{clutch.threshold:g} V"
            problems.add((*path, "threshold"), "at or above full scale", value, right)


def _check_laws(s: Scenario, problems: Problems) -> None:
    seen = set()
    for i, clutch in enumerate(s.clutches):
        path = (*clutch_path(problems, i), "torque")
        if path in seen or not 0.0 < clutch.full_scale < math.inf:
            continue
        seen.add(path)
        for finding in check_law(clutch.torque, clutch.full_scale):
            problems.add(path, finding.what, finding.value, finding.right)


def _check_stages(s: Scenario, problems: Problems) -> None:
    """No stage may command more than the clutches take."""
    most = min((c.full_scale for c in s.clutches), default=math.inf)
    for k, (stage, _) in enumerate(s.controllers):
        path = ("controller", "stages", k)
        right = f"at most the clutches' full scale, {most:g} V"
        value = getattr(stage, "full_scale", 0.0)
        if value > most:
            problems.add((*path, "full_scale"), "beyond full scale", f"{value:g} V", right)
        for f in dataclasses.fields(stage):
            names = [name for name, _ in f.metadata.get("columns", ())]
            if "command" in names:
                column = [row[names.index("command")] for row in getattr(stage, f.name)]
                if column and max(column) > most:
                    what, value = "command beyond full scale", f"{max(column):g} V"
                    problems.add((*path, f.name), what, value, right)


def _check_records(s: Scenario, problems: Problems) -> None:
    for k, load in enumerate(s.loads):
        covers = getattr(load, "covers", None)
        if covers is not None:
            first, last = covers()
            if first > 0.0 or last < s.t_end:
                what = f"the record from {first:g} s to {last:g} s does not cover the run"
                right = f"t_end of at most {last:g} s"
                problems.add(("loads", k), what, f"{s.t_end:g} s", right)


def _check_start(s: Scenario, problems: Problems) -> None:
    """The model can be put together and evaluated where the run begins."""
    try:
        md = s.python_model()
        y, w = s.initial(lambda k: [0.0] * k, lambda k: [0] * k)
    except Exception as error:  # parts that do not fit, or a user's function that is no function
        what = f"the parts do not fit together ({error})"
        return problems.add(_path_in(str(error), s), what, s.name, "parts that fit the device")

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
        path = clutch_path(problems, int(path[1])) if path[:1] == ("clutches",) else path
        return problems.add(path, f"{name} {what}", s.name, "finite numbers")
    if wrong := held_not_finite(s, w.held):
        what = f"at the first sample {wrong}"
        problems.add(("controller",), what, s.name, "finite numbers")
    before = len(problems)
    _check_mass(s, problems, list(w.M))
    if len(problems) == before:
        for found in check_device(s.device, [s.q]):
            problems.add(("device",), f"{found.array}: {found.what}", found.value, found.right)
    for k, stop in enumerate(s.stops):
        value = w.g[2 * md.m + k]
        if value < 0.0:
            reason = getattr(stop, "reason", type(stop).__name__)
            what = f"the run would end as it starts ({reason})"
            problems.add(_stop_path(s, k, problems), what, round(value, 9), "a start before it")


def _stop_path(s: Scenario, k: int, problems: Problems) -> KeyPath:
    return ("stops", k) if ("stops", k) in problems.places else ("start",)


def _check_mass(s: Scenario, problems: Problems, M: list[float]) -> None:
    """The mass matrix is symmetric and positive definite where the run begins."""
    n = s.device.n
    size = max(abs(v) for v in M[: n * n])
    skew = max((abs(M[a * n + b] - M[b * n + a]) for a in range(n) for b in range(a)), default=0.0)
    if skew > 1e-9 * size:
        problems.add(("device",), "the mass matrix is not symmetric", skew, "a symmetric matrix")
    for k in range(1, n + 1):
        block = [M[a * n + b] for a in range(k) for b in range(k)]
        if _determinant(block, k) <= 0.0:
            what = f"the mass matrix at the start is not positive definite (leading block {k})"
            right = "inertias with positive kinetic energy for every motion"
            return problems.add(("device",), what, [round(v, 9) for v in M[: n * n]], right)


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


def _names(message: str, part: Part) -> bool:
    return f"{type(part).__name__}." in message or f"({type(part).__name__})" in message
