"""What a worker does: some cases in, the bytes of their result files out."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..measuring.metrics import instants
from ..measuring.sampling import sample
from ..problems import InvalidInput
from ..scenario import Scenario
from ..trajectory import Trajectory
from .base import Base
from .brief import Measured, OwnMeasure, brief, everything, sampled
from .case import GOOD, Record
from .code_version import code_version
from .tip_motion import tip_motion


@dataclass(frozen=True)
class Options:
    """How cases are run and measured.

    Parameters
    ----------
    engine : str
        ``compiled`` or ``reference``.
    measures : str or callable
        ``brief``, ``all``, or a function of a run that hands back numbers by name.
    step : float
        Sampling step of the measures [s].
    code : str
        ``code_version()`` of the program that started the sweep.
    """

    engine: str
    measures: str | OwnMeasure
    step: float
    code: str


@dataclass(frozen=True)
class Case:
    """A case to be run: its name and the values that make it."""

    name: str
    given: tuple[tuple[str, str], ...]


class OtherProgram(RuntimeError):
    """A worker that runs other sources than the program that started the sweep."""


def run_cases(base: Base, options: Options, cases: Sequence[Case]) -> list[tuple[str, bytes]]:
    """Run cases one by one or, with the compiled engine, together; results do not depend on it.

    Parameters
    ----------
    base : Base
    options : Options
    cases : sequence of Case

    Returns
    -------
    list of (str, bytes)
        Name and content of the result file of every case.

    Raises
    ------
    OtherProgram
    """
    if code_version() != options.code:
        raise OtherProgram(
            "a worker runs another version of simpter_hybrid, Python, NumPy, SciPy or llvmlite "
            "than the program that started the sweep; give all of them the same"
        )
    records: dict[int, Record] = {}
    ready: dict[int, Scenario] = {}
    for k, case in enumerate(cases):
        try:
            ready[k] = base.scenario([f"{path}={value}" for path, value in case.given])
        except InvalidInput as error:
            records[k] = _record(case, "invalid", str(error))
        except Exception as error:  # whatever a user's part does when it is made
            records[k] = _record(case, "error", _said(error))
    runner: Callable = compiled_cases if options.engine == "compiled" else reference_cases
    records |= runner(options, cases, ready)
    return [(case.name, records[k].to_bytes()) for k, case in enumerate(cases)]


def reference_cases(
    options: Options, cases: Sequence[Case], ready: Mapping[int, Scenario]
) -> dict[int, Record]:
    """Records of cases run by the reference engine.

    Parameters
    ----------
    options : Options
    cases : sequence of Case
    ready : mapping of int to Scenario
        Those to be run, by their numbers in ``cases``.

    Returns
    -------
    dict
        By the same numbers.
    """
    from ..engine import simulate

    found = {}
    for k, scenario in ready.items():
        try:
            run = simulate(scenario)
            found[k] = _of_run(cases[k], options, run, sampled)
        except Exception as error:
            found[k] = _record(cases[k], "error", _said(error))
    return found


def compiled_cases(
    options: Options, cases: Sequence[Case], ready: Mapping[int, Scenario]
) -> dict[int, Record]:
    """Records of cases run by the compiled engine, those of one structure in one call.

    Parameters
    ----------
    options, cases, ready
        As for `reference_cases`.

    Returns
    -------
    dict
        By the same numbers.
    """
    from .batch import run_batch

    found: dict[int, Record] = {}

    def together(numbers: Sequence[int]) -> None:
        for j, run, rows in run_batch([ready[k] for k in numbers], options.step):

            def on_rows(run: Trajectory, step: float, rows: Any = rows) -> Measured:
                count = len(instants(run.t_end, step))
                columns = [rows.q[:count].copy(), rows.qd[:count].copy(), rows.qdd[:count].copy()]
                unwritten = np.isnan(columns[2]).any(axis=1)
                if unwritten.any():
                    # A run that stops at an instant, or a rounding before it, has no row after it.
                    taken = sample(run, instants(run.t_end, step)[unwritten])
                    for column, name in zip(columns, ("q", "qd", "qdd"), strict=True):
                        column[unwritten] = getattr(taken, name)
                return brief(run, step, *tip_motion(run.scenario, *columns))

            k = numbers[j]
            found[k] = _of_run(cases[k], options, run, on_rows)

    try:
        together(list(ready))
    except Exception:  # one case that cannot be compiled must not take the others with it
        for k in ready.keys() - found.keys():
            try:
                together([k])
            except Exception as error:
                found[k] = _record(cases[k], "error", _said(error))
    return found


def _of_run(
    case: Case, options: Options, run: Trajectory, quick: Callable[[Trajectory, float], Measured]
) -> Record:
    if run.status not in GOOD:
        return _record(case, run.status, run.message, run.t_end)
    try:
        if callable(options.measures):
            taken: Mapping[str, Any] = dict(options.measures(run))
        else:
            taken = (everything if options.measures == "all" else quick)(run, options.step)
        record = _record(case, run.status, run.message, run.t_end, taken)
        record.to_bytes()  # what cannot be written is an error of the measure
        return record
    except Exception as error:
        return _record(case, "error", f"the measures: {_said(error)}", run.t_end)


def _record(
    case: Case, status: str, message: str, time: float | None = None,
    measures: Mapping[str, float | None] | None = None,
) -> Record:  # fmt: skip
    return Record(case.name, dict(case.given), status, message, time, measures or {})


def _said(error: Exception) -> str:
    return f"{type(error).__name__}: {error}"
