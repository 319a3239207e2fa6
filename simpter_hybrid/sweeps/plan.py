"""What a sweep is going to do, checked whole before anything is written."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from ..engines import ENGINES
from ..files.scenario_text import resolve
from ..measuring.metrics import instants
from ..problems import CompiledUnavailable, InvalidInput, Problem, Problems
from ..reading.reader import one_of
from ..scenario import Scenario
from ..units import QuantityError, parse_quantity
from .axis import Axis, axis_of, listed, number_of, quantity_text, read_axis
from .base import Base, base_of, content, fingerprint
from .brief import FEWEST, OwnMeasure, measure_names
from .case import case_name
from .code_version import code_version
from .design import Design, design, read_cases
from .measure_identity import UnidentifiedMeasure, measures_identity
from .results import SweepDirectory
from .work import Case, Options

FORMAT = "simpter_hybrid sweep 1"
MEASURES = ("brief", "all")
#: Values of one path that are all tried before the sweep begins; of more, the first and the last.
TRIED = 40
#: Rows on which the measures of one run are taken.
MOST_ROWS = 2_000_000
#: Where a scenario has the end of its runs.
END = "run.t_end"

Vary = Mapping[str, str | Sequence[str | float]] | Sequence[str]


@dataclass(frozen=True)
class Request:
    """What was asked for; see ``simpter_hybrid.sweep`` for the meaning of the fields."""

    scenario: Scenario | str | os.PathLike
    vary: Vary
    out: str | os.PathLike
    overrides: Sequence[str] = ()
    cases: str | os.PathLike | None = None
    sample: int | None = None
    method: str = "sobol"
    seed: int = 0
    engine: str = "compiled"
    measures: str | OwnMeasure = "brief"
    step: float | str = 1e-3
    jobs: int = 1
    chunk: int | None = None
    show: Sequence[str] = ()


@dataclass(frozen=True)
class Plan:
    """A sweep that can begin.

    Parameters
    ----------
    base, design, options
    scenario : Scenario
        The one that is varied.
    cases : tuple of Case
        In the order of the design.
    directory : SweepDirectory
    files : mapping of str to str
        The scenario that is varied, written out in full, and the files it names.
    jobs, chunk
        As in the request.
    """

    base: Base
    design: Design
    options: Options
    scenario: Scenario
    cases: tuple[Case, ...]
    directory: SweepDirectory
    files: Mapping[str, str]
    jobs: int
    chunk: int | None


def make_plan(request: Request, more: Sequence[Problem] = ()) -> Plan:
    """Check a request and name its cases.

    Parameters
    ----------
    request : Request
    more : sequence of Problem
        What the caller knows to be wrong already.

    Raises
    ------
    InvalidInput
        With everything that is wrong with it; nothing has been written.
    """
    problems = Problems("simpter sweep")
    found = _design_of(request, problems)
    step = _check_options(request, problems)
    more = list(more)
    identities: dict[tuple[str, str], str] = {}
    try:
        base = base_of(request.scenario, request.overrides)
        scenario = base.scenario()
        more += _check_engine(request.engine, scenario) + _check_shown(request, scenario)
        if found is None or END not in found.paths:
            more += _check_step(step, scenario, request)
        if found is not None:
            more += _try_values(base, found, step, identities, request)
    except InvalidInput as error:
        more += error.problems
    if len(problems) or more or found is None:
        raise _invalid(problems, more, SweepDirectory(request.out, {}))
    options = Options(request.engine, request.measures, step, code_version())
    return _named(request, options, base, scenario, found, identities)


def _named(
    request: Request, options: Options, base: Base, scenario: Scenario, found: Design,
    identities: Mapping[tuple[str, str], str],
) -> Plan:  # fmt: skip
    """The plan, its cases named by what their results depend on."""
    resolved = resolve(scenario)
    origin = fingerprint(base.data(), content(resolved))
    how = {"engine": options.engine, "measures": measures_identity(options.measures),
           "step_s": options.step, "program": options.code}  # fmt: skip
    given = [tuple(zip(found.paths, row, strict=True)) for row in found.rows]
    shown = [[(p, identities.get((p, v), v)) for p, v in pairs] for pairs in given]
    chosen = fingerprint(how)
    cases = tuple(
        Case(case_name(origin, seen, chosen), pairs)
        for seen, pairs in zip(shown, given, strict=True)
    )
    about = {
        "format": FORMAT, "name": scenario.name, "scenario": origin, "cases": len(found),
        "paths": list(found.paths), "design": fingerprint(found.paths, shown), **how,
    }  # fmt: skip
    directory = SweepDirectory(request.out, about)
    directory.check()
    files = {"scenario.toml": resolved.text, **resolved.files}
    return Plan(
        base, found, options, scenario, cases, directory, files, request.jobs, request.chunk
    )


def _invalid(
    problems: Problems, more: Sequence[Problem], directory: SweepDirectory
) -> InvalidInput:
    """All problems, those of the directory among them."""
    found = list(more)
    for check in (problems.raise_if_any, directory.check):
        try:
            check()
        except InvalidInput as error:
            found += error.problems
    return InvalidInput(dict.fromkeys(found))


def _design_of(request: Request, problems: Problems) -> Design | None:
    """The design asked for; None (and problems) if it is none."""
    before = len(problems)
    cases = read_cases(request.cases, problems) if request.cases is not None else None
    axes: list[Axis | None] = []
    if isinstance(request.vary, Mapping):
        for path, values in request.vary.items():
            if isinstance(values, str):
                axes.append(axis_of(path, values, problems, f"vary {path}"))
            else:
                texts = [v if isinstance(v, str) else quantity_text(float(v), "") for v in values]
                axes.append(listed(path, texts, problems, f"vary {path}"))
    else:
        axes = [read_axis(text, problems) for text in request.vary]
    if len(problems) > before:
        return None
    known = [axis for axis in axes if axis is not None]
    return design(
        known, problems, cases=cases, sample=request.sample, method=request.method,
        seed=request.seed,
    )  # fmt: skip


def _check_options(request: Request, problems: Problems) -> float:
    """Record what is wrong with the options; returns the step [s]."""
    if request.engine not in ENGINES:
        right = f"one of {', '.join(ENGINES)}"
        problems.add((), "unknown engine", request.engine, right, "--engine")
    if not callable(request.measures) and request.measures not in MEASURES:
        right = f"one of {', '.join(MEASURES)}, or in Python a function of a run"
        problems.add((), "no such measures", request.measures, right, "--measures")
    try:
        measures_identity(request.measures)
    except UnidentifiedMeasure as error:
        problems.add((), error.what, error.got, error.right, "--measures")
    if request.jobs < 1:
        problems.add((), "not a number of processes", request.jobs, "1 or more", "--jobs")
    if request.chunk is not None and request.chunk < 1:
        problems.add((), "not a number of cases", request.chunk, "1 or more", "--chunk")
    step = 0.0
    try:
        step = (
            parse_quantity(request.step, "time")
            if isinstance(request.step, str)
            else (float(request.step))
        )
        if not 0.0 < step < float("inf"):
            problems.add((), "not a step", request.step, "a positive time", "--step")
    except QuantityError as error:
        problems.add((), error.what, error.value, error.right, "--step")
    return step


def _check_step(step: float, scenario: Scenario, request: Request) -> list[Problem]:
    """The problem of a step that does not suit the longest run of a scenario.

    Measures of one's own do not go by it.
    """
    t_end = scenario.t_end
    if step > 0.0 and t_end / step > MOST_ROWS:
        what = f"{t_end:g} s would have more than {MOST_ROWS} instants"
        right = f"a step of at least {t_end / MOST_ROWS:.2g} s"
        return [Problem("--step", "", what, f"{step:g} s", right)]
    if not callable(request.measures) and step > 0.0 and len(instants(t_end, step)) < FEWEST:
        what = f"{t_end:g} s would have fewer than {FEWEST} instants"
        right = f"a step of at most {t_end / (FEWEST - 1):g} s"
        return [Problem("--step", "", what, f"{step:g} s", right)]
    return []


def _check_shown(request: Request, scenario: Scenario) -> list[Problem]:
    """Problems of measures that are to be drawn; names of one's own are known when they come."""
    if request.measures not in MEASURES:
        return []
    names = measure_names(request.measures, scenario.device)  # type: ignore[arg-type]
    what = f"no measure of --measures {request.measures}"
    return [
        Problem("--show", "", what, f'"{name}"', one_of(names, name))
        for name in request.show
        if name not in names
    ]


def _check_engine(engine: str, scenario: Scenario) -> list[Problem]:
    found: list[Problem] = []
    if engine == "compiled":
        from ..machine_code.program import Program

        try:
            Program(scenario)
        except CompiledUnavailable as error:
            found += error.invalid("--engine", "--engine reference").problems
    return found


def _try_values(
    base: Base, found: Design, step: float, identities: dict[tuple[str, str], str],
    request: Request,
) -> list[Problem]:  # fmt: skip
    """Problems of the values varied, each tried alone and, where that fails, in its first case."""
    problems: list[Problem] = []
    for k, path in enumerate(found.paths):
        first: dict[str, tuple[str, ...]] = {}
        for row in found.rows:
            first.setdefault(row[k], row)
        plain = [v for v in first if number_of(v) is not None]
        few = plain if len(plain) <= TRIED else [plain[0], plain[-1]]
        for value in [*few, *(v for v in first if number_of(v) is None)]:
            try:
                scenario = base.scenario([f"{path}={value}"])
            except InvalidInput as error:
                pairs = zip(found.paths, first[value], strict=True)
                try:
                    scenario = base.scenario([f"{p}={v}" for p, v in pairs])
                except InvalidInput:
                    problems += [_at_vary(p, path) for p in error.problems]
                    continue
            if path == END:
                problems += _check_step(step, scenario, request)
            if number_of(value) is None:  # it may name a file: what is in it counts
                identities[path, value] = content(resolve(scenario))
    return problems


def _at_vary(problem: Problem, path: str) -> Problem:
    where = problem.where
    if where.startswith("--set"):
        where = f"--vary {where.removeprefix('--set').strip()}"
    elif problem.path != path:
        where = f"--vary {path}: {where}"
    return problem._replace(where=where)
