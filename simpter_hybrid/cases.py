"""Cases that differ in parameters, initial states or recorded data, by name."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from .applied_load import Load
from .machine_code.program import Cases, Program
from .scenario import Scenario


class CannotVary(ValueError):
    """A name that is not known, or values that cannot be given case by case."""


def varied(
    program: Program, vary: Mapping[str, np.ndarray], data: np.ndarray | None = None
) -> Cases:
    """Cases with the columns named in ``vary`` changed.

    Parameters
    ----------
    program : Program
    vary : mapping
        Arrays (cases,) [SI], by name: a parameter (``clutch.1.torque.scale``; see
        ``Scenario.parameter_names``), ``q.<coordinate>``, ``qd.<coordinate>``,
        ``command.<clutch>``, ``excitation.<clutch>``.
    data : ndarray, (cases, k), optional
        Recorded data of every case.

    Raises
    ------
    CannotVary
    """
    columns = {name: np.atleast_1d(np.asarray(v, dtype=float)) for name, v in vary.items()}
    counts = {name: len(column) for name, column in columns.items()}
    if data is not None:
        counts["data"] = len(data)
    if not counts:
        raise CannotVary("nothing is varied; name at least one parameter or initial value")
    if len(set(counts.values())) > 1:
        raise CannotVary(f"the numbers of cases differ: {counts}")
    if 0 in counts.values():
        raise CannotVary("columns of no case; give at least one value each")
    cases = program.cases(next(iter(counts.values())))
    if data is not None:
        cases.data = np.ascontiguousarray(data, dtype=float)
    parameters = {name: k for k, name in enumerate(program.scenario.parameter_names())}
    starts = start_columns(program)
    for name, column in columns.items():
        if not np.isfinite(column).all():
            raise CannotVary(f"{name}: case {int(np.argmin(np.isfinite(column)))} is not finite")
        if name in starts:
            cases.starts[:, starts[name]] = column
        elif name in parameters:
            cases.parameters[:, parameters[name]] = column
            switching(program, cases, name, column)
        else:
            known = ", ".join([*starts, *parameters])
            raise CannotVary(f"{name!r} is not known; known are: {known}")
    breakpoints(program.scenario, {k: v for k, v in columns.items() if k in parameters})
    return cases


def rising(grid: ArrayLike) -> np.ndarray:
    """Output instants as the kernel wants them: it passes them in their order, looking once.

    Parameters
    ----------
    grid : array_like, (g,)
        [s].

    Raises
    ------
    ValueError
        If one is earlier than the one before it.
    """
    found = np.ascontiguousarray(grid, dtype=float)
    if (np.diff(found) < 0.0).any():
        raise ValueError("the instants of the grid must rise")
    return found


def start_columns(program: Program) -> dict[str, int]:
    """Columns of ``Cases.starts`` by name.

    Parameters
    ----------
    program : Program
        Of the scenario that is varied.

    Returns
    -------
    dict
        Names as in ``varied`` -> columns, from 0.
    """
    n, m = program.z["n"], program.z["m"]
    found = {}
    for j, coordinate in enumerate(program.scenario.device.coordinates):
        found[f"q.{coordinate}"], found[f"qd.{coordinate}"] = j, n + j
    for i in range(m):
        found[f"command.{i + 1}"], found[f"excitation.{i + 1}"] = 2 * n + i, 2 * n + m + i
    return found


def switching(program: Program, cases: Cases, name: str, column: np.ndarray) -> None:
    """Take over what the kernel keeps beside the parameters: delay and threshold of a clutch.

    Parameters
    ----------
    program : Program
    cases : Cases
        Changed in place.
    name : str
        A parameter that is varied, e.g. ``clutch.1.delay``.
    column : ndarray (cases,)
        Its values [SI].

    Raises
    ------
    CannotVary
        If an effect changes the delay or the threshold, or a time constant is 0 in some cases only.
    """
    words = name.split(".")
    s = program.scenario
    if words[0] == "effect":
        effect = s.effects[int(words[1]) - 1]
        own = type(effect)
        if any(
            getattr(own, method) is not getattr(base, method)
            for base in own.__mro__
            if base.__name__ == "Effect"
            for method in ("changed_delay", "changed_threshold")
            if hasattr(base, method)
        ):
            raise CannotVary(
                f"{name}: {own.__name__} changes the delay or the threshold of a clutch, which is "
                "fixed before a run; make one scenario a value"
            )
    if words[0] != "clutch" or len(words) != 3:
        return
    i = int(words[1]) - 1
    if words[2] in ("delay", "threshold"):
        if program.switching[words[2]][i] != getattr(s.clutches[i], words[2]):
            raise CannotVary(f"{name}: an effect changes it; vary that of a scenario without it")
        getattr(cases, words[2])[:, i] = column
    prompt = s.clutches[i].time_constant == 0.0
    if words[2] == "time_constant" and ((column == 0.0) != prompt).any():
        raise CannotVary(
            f"{name}: 0 s (no lag) and other values are different models; make two ensembles"
        )


def breakpoints(scenario: Scenario, columns: Mapping[str, np.ndarray]) -> None:
    """Refuse to move instants at which a run is stopped to restart its solver.

    Parameters
    ----------
    scenario : Scenario
    columns : mapping
        Parameters that are varied, by name, and their values in every case [SI].

    Raises
    ------
    CannotVary
        If the breakpoints of a load depend on them, as those of tables and ramps do.
    """
    for k, load in enumerate(scenario.loads):
        mine = f"load.{k + 1}."
        names = [name for name in columns if name.startswith(mine)]
        if not names or type(load).breakpoints is Load.breakpoints:
            continue
        own = f"{', '.join(names)}: its load has breakpoints in time"
        fields = [name.removeprefix(mine) for name in names]
        if any(field.partition(".")[0] == "table" for field in fields):
            if load.breakpoints():
                raise CannotVary(f"{own}; make one scenario a value")
            continue
        fixed = within(scenario, load)
        for values in np.unique(np.column_stack([columns[name] for name in names]), axis=0):
            try:
                moved = replace(load, **dict(zip(fields, values.tolist(), strict=True)))
            except ValueError as error:
                raise CannotVary(f"{', '.join(names)}: {error}") from None
            # One that falls away (a slope of 0 has none) is an instant too many and no more.
            if not set(within(scenario, moved)) <= set(fixed):
                raise CannotVary(f"{own}, which would move; make one scenario a value")


def within(scenario: Scenario, load: Load) -> list[float]:
    """The breakpoints of a load that fall within the run [s].

    Parameters
    ----------
    scenario : Scenario
    load : Load
        Of it, or in place of one of it.
    """
    return sorted({t for t in load.breakpoints() if 0.0 < t < scenario.t_end})
