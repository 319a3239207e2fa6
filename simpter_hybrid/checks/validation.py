"""What is wrong with a scenario, found before it runs, all at once."""

from __future__ import annotations

import dataclasses
import math
from numbers import Integral

from ..controller import Controller
from ..problems import KeyPath, Problems
from ..scenario import METHODS, Scenario
from .effect_check import check_effects
from .index_check import check_indices
from .law_check import check_law
from .start_check import check_start, clutch_path

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
    check_effects(scenario, problems)
    check_indices(scenario, problems)
    _check_records(scenario, problems)
    if len(problems) == before:
        check_start(scenario, problems)


def validate(scenario: Scenario) -> None:
    """Check a scenario that was made in Python.

    Raises
    ------
    InvalidInput
        With everything that is wrong with it.
    """
    problems = Problems(f"Scenario({scenario.name!r})")
    check_scenario(scenario, problems)
    problems.raise_if_any()


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
    )  # fmt: skip
    for key, value, low, high in limits:
        if not (low < value <= high and math.isfinite(value)):
            top = f" and at most {high:g}" if math.isfinite(high) else ", finite"
            problems.add(("run", key), "out of range", value, f"above {low:g}{top} (SI)")
    whole = isinstance(s.event_limit, Integral) and not isinstance(s.event_limit, bool)
    if not (whole and s.event_limit > 0):
        right = "a whole number above 0, e.g. 100000"
        problems.add(("run", "event_limit"), "no number of events", s.event_limit, right)
    if s.method not in METHODS:
        problems.add(
            ("run", "method"), "not a valid name", s.method, f"one of {', '.join(METHODS)}"
        )
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
        for name in ("time_constant", "delay"):
            value = getattr(clutch, name)
            if not 0.0 <= value < math.inf:
                right = "a time of 0 s or more, finite"
                problems.add((*path, name), "out of range", f"{value:g} s", right)
        if not 1e-300 <= full < math.inf:
            right = "a voltage above 0 V, finite"
            problems.add((*path, "full_scale"), "out of range", f"{full:g} V", right)
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
        for finding in check_law(clutch.torque, clutch.full_scale, s.device.surface_units):
            problems.add(path, finding.what, finding.value, finding.right)


def _check_stages(s: Scenario, problems: Problems) -> None:
    """No stage may command more than the clutches take, or be asked for more than it keeps."""
    most = min((c.full_scale for c in s.clutches), default=math.inf)
    for k, (stage, every) in enumerate(s.controllers):
        path = ("controller", "stages", k)
        if 0 < stage.most_coordinates < s.device.n:
            right = f"a device of at most {stage.most_coordinates}"
            problems.add((*path, "kind"), "too many coordinates", s.device.n, right)
        _check_made_for(s, stage, (*path, "kind"), problems)
        longest = (stage.kept_samples - 1) * every * s.period
        if stage.kept_samples and (delay := getattr(stage, "delay", 0.0)) > longest:
            what, right = "beyond the past that is kept", f"at most {longest:g} s, or a lower rate"
            problems.add((*path, "delay"), what, f"{delay:g} s", right)
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


def _check_made_for(s: Scenario, stage: Controller, path: KeyPath, problems: Problems) -> None:
    n, m = stage.made_for
    if n and (s.device.n != n or s.device.m < m):
        of_clutches = f" and {m} clutches" if m else ""
        what = f"{type(stage).__name__} is for devices of {n} coordinates{of_clutches}"
        value = f"{s.device.n} coordinates and {s.device.m} clutches"
        more = f" (with more than {m} clutches too)" if m else ""
        right = f"such a device{more}, or another stage"
        problems.add(path, what, value, right)


def _check_records(s: Scenario, problems: Problems) -> None:
    for k, load in enumerate(s.loads):
        covers = getattr(load, "covers", None)
        if covers is not None:
            first, last = covers()
            what = f"the record from {first:g} s to {last:g} s does not cover the run"
            if first > 0.0:
                right = "a first instant of 0 s or before: shift the times, or add what came before"
                problems.add(("loads", k), f"{what}, which begins at 0 s", f"{first:g} s", right)
            if last < s.t_end:
                right = f"t_end of at most {last:g} s"
                problems.add(("loads", k), what, f"{s.t_end:g} s", right)
