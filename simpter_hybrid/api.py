"""The Python API: ``load`` a scenario, ``run`` it, ``plot`` what happened; ``sweep`` it.

And ``diagnose`` what a model lacks against a recording.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .engines import ENGINES
from .files.scenario_file import load
from .files.storage import load as load_run
from .problems import CompiledUnavailable, InvalidInput, Problem
from .scenario import Scenario
from .trajectory import Trajectory

if TYPE_CHECKING:
    from .diagnosis_report import DiagnosisReport
    from .effect import Effect
    from .sweeps.plan import Vary
    from .sweeps.run import State
    from .sweeps.table import Table

__all__ = ["ENGINES", "diagnose", "load", "load_run", "plot", "run", "save", "sweep"]


def run(
    scenario: Scenario | str | os.PathLike,
    overrides: Sequence[str] = (),
    engine: str = "reference",
    progress: Callable[[float], None] | None = None,
) -> Trajectory:
    """Run a scenario.

    Parameters
    ----------
    scenario : Scenario, str or path
        What ``load`` returned, or what it takes.
    overrides : sequence of str
        ``path=value``; only with a name or path.
    engine : str
        ``reference`` or ``compiled``.
    progress : callable, optional
        Called with the instant reached [s]; a KeyboardInterrupt raised in it ends the run and keeps
        what there is.

    Returns
    -------
    Trajectory
        Also when the run fails; see its ``status`` and ``message``.

    Raises
    ------
    InvalidInput
        With everything that is wrong with the scenario, or if there is no such engine.
    TypeError
        If overrides are given with a Scenario.
    """
    from .checks.validation import validate

    if not isinstance(scenario, Scenario):
        scenario = load(scenario, overrides)
    elif overrides:
        raise TypeError("overrides change a file; use scenario.replace(...) for a Scenario")
    else:
        validate(scenario)
    if engine == "compiled":
        from . import compiled

        try:
            return compiled.simulate(scenario, progress)
        except CompiledUnavailable as error:
            raise error.invalid("engine", "engine reference") from None
    if engine != "reference":
        right = f"one of {', '.join(ENGINES)}"
        raise InvalidInput([Problem("engine", "", "unknown engine", str(engine), right)])
    from .engine import simulate

    return simulate(scenario, progress)


def save(
    trajectory: Trajectory,
    directory: str | Path,
    overwrite: bool = False,
    also: Callable[[Path], None] | None = None,
) -> Path:
    """Write a run's files, its resolved scenario among them.

    Parameters
    ----------
    trajectory : Trajectory
        The run to write.
    directory : path
        Made if needed; appears complete or not at all.
    overwrite : bool
        Replace a directory that holds a run.
    also : callable, optional
        Called with the directory to add further files before it gets its name.

    Raises
    ------
    RunDirectoryError
        If the directory must not be written to.
    ValueError
        If a part of the scenario cannot be written to a file.
    """
    from .files import storage
    from .files.scenario_text import resolve

    resolved = resolve(trajectory.scenario)
    return storage.save(
        trajectory, directory, resolved.text, files=resolved.files, overwrite=overwrite, also=also
    )


def plot(trajectory: Trajectory, directory: str | Path = "pictures") -> list[Path]:
    """Write the pictures of a run as PNG files; returns their paths.

    Parameters
    ----------
    trajectory : Trajectory
        Shown in the units of its scenario (``units`` in its file), else in SI units.
    directory : path
        Made if needed.

    Raises
    ------
    ValueError
        For a run that ended before it began: there is nothing to draw.
    """
    from .plots import DISPLAYS, plot

    units = trajectory.scenario.notes.get("units", "SI")
    return plot(trajectory, directory, DISPLAYS[units])


def sweep(
    scenario: Scenario | str | os.PathLike,
    vary: Vary,
    out: str | os.PathLike,
    *,
    overrides: Sequence[str] = (),
    cases: str | os.PathLike | None = None,
    sample: int | None = None,
    method: str = "sobol",
    seed: int = 0,
    engine: str = "compiled",
    measures: str | Callable[[Trajectory], Mapping[str, float]] = "brief",
    step: float | str = 1e-3,
    jobs: int = 1,
    executor: Executor | None = None,
    chunk: int | None = None,
    report: Callable[[State], Any] | None = None,
) -> Table:
    """Run a scenario once for every combination of the values in ``vary``.

    Every case leaves a file in ``out``, written whole; called again, only cases without one are
    run. Files and table are the same bytes whatever executor, chunks and order of completion.

    Parameters
    ----------
    scenario : Scenario, str or path
        For a Scenario the paths are those of its resolved form (``simpter show --resolved``).
    vary : mapping or sequence of str
        By path (as in ``load``'s overrides) a list of values or a text: ``"0:0.6 V/(lbf*in):31"``
        is a range, ``"5..9 lbf"`` an interval to draw ``sample`` points from, with ``:log`` behind
        it uniform in the logarithm. Or the texts of ``simpter sweep --vary``.
    out : path
        The sweep's directory.
    overrides : sequence of str
        ``path=value``, for all cases.
    cases : path, optional
        CSV file of further paths and their values, a case a line.
    sample, method, seed
        Points drawn: ``sobol``, ``halton`` (scrambled), ``lhs`` (``scipy.stats.qmc``), or
        ``saltelli`` for Sobol indices (``sweeps.indices.indices``).
    engine : str
        ``compiled``: cases of one structure are run together, to the same bits; or ``reference``.
    measures : str or callable
        ``brief``; ``all`` of ``metrics.measures``; or a function of a run that hands back numbers
        by name (of a module, so that other processes find it; what it depends on tells it from
        others).
    step : float or str
        Sampling step of the measures [s].
    jobs : int
        Processes of this machine, where no executor is given; workers it has, where one is.
    executor : Executor, optional
        Any of ``concurrent.futures``, or Dask's ``client.get_executor(pure=False)``.
    chunk : int, optional
        Cases handed out at a time.
    report : callable, optional
        Called with how far the sweep is (``done``, ``total``, ``failed``).

    Returns
    -------
    Table
        Cases in the order of the design; failed ones with their reason.

    Raises
    ------
    InvalidInput
        With everything that is wrong with the request, or if ``out`` is a different sweep's.
    """
    from .sweeps.plan import Request, make_plan
    from .sweeps.run import Sweep

    request = Request(
        scenario, vary, out, overrides, cases, sample, method, seed, engine, measures, step, jobs,
        chunk,
    )  # fmt: skip
    return Sweep(make_plan(request), executor, report).work()


def diagnose(
    recordings: str | os.PathLike | Sequence[str | os.PathLike],
    model: str | os.PathLike,
    recording_map: str | os.PathLike | None = None,
    *,
    also: str | type[Effect] | Sequence[str | type[Effect]] = (),
    without: str | Sequence[str] = (),
    effort: float = 1.0,
    trials: int = 0,
    sight: bool = True,
    progress: Callable[[str], None] = lambda text: None,
    remark: Callable[[str], None] | None = None,
) -> DiagnosisReport:
    """Trace measured data to what a model lacks.

    Parameters
    ----------
    recordings : path or sequence of paths
        CSV, TSV (also gzipped), NPZ, MAT or TDMS; several if each holds a run.
    model : path
        The declared model's TOML file, or the name of one that comes with the program.
    recording_map : path, optional
        Column -> signal, unit, sign; default: ``MODEL_map.toml`` beside the model, else
        ``map.toml`` beside the recording, else that of a shipped model.
    also : str, type or sequence of them
        Effects tried beside the library: kinds, ``module:Class`` of a file beside the model, or
        classes of a module.
    without : str or sequence of str
        Effects that are not tried, by their names in verdicts.
    effort : float
        How much may be simulated, in times the usual (a quarter of an hour on two cores).
    trials : int
        Synthetic sets of these runs, in which nothing is missing, that are diagnosed as well.
    sight : bool
        Whether it is asked what these experiments cannot show, and which run would tell most.
    progress, remark : callable
        Told what is being done, and what may be wrong with the data (default: as `progress`).

    Returns
    -------
    DiagnosisReport
        ``str`` of it is the verdict in sentences; ``data`` is all that is told; ``corrected`` the
        corrected model, to be run; ``save`` writes the report.

    Raises
    ------
    InvalidInput
        With everything that is wrong with the files, the numbers or the task.
    CompiledUnavailable
        If what compiles the engine is not installed (extra ``compiled``).
    """
    from .diagnosis_report import diagnosed
    from .identification.reporting.request import read_request

    request = read_request(
        recordings, model, recording_map, also=also, without=without, effort=effort,
        trials=trials, sight=sight,
    )  # fmt: skip
    return diagnosed(request, progress, remark)
