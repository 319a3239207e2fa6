"""The Python API: ``load`` a scenario, ``run`` it, ``plot`` what happened."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from pathlib import Path

from .problems import InvalidInput, Problem
from .scenario import Scenario
from .scenario_file import load
from .trajectory import Trajectory

__all__ = ["ENGINES", "load", "plot", "run", "save"]

ENGINES = ("reference", "compiled")


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
        Called with the instant reached [s] (reference engine).

    Returns
    -------
    Trajectory
        Also when the run fails; see its ``status`` and ``message``.

    Raises
    ------
    InvalidInput
        With everything that is wrong with the scenario.
    """
    from .validation import validate

    if not isinstance(scenario, Scenario):
        scenario = load(scenario, overrides)
    elif overrides:
        raise TypeError("overrides change a file; use scenario.replace(...) for a Scenario")
    else:
        validate(scenario)
    if engine == "compiled":
        from . import compiled

        try:
            return compiled.simulate(scenario)
        except compiled.CompiledUnavailable as error:
            right = "llvmlite, by: pip install 'simpter-hybrid[compiled]'; or engine reference"
            raise InvalidInput([Problem("engine", "", str(error), engine, right)]) from None
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
    from . import storage
    from .scenario_text import resolve

    resolved = resolve(trajectory.scenario)

    def write(partial: Path) -> None:
        for name, text in resolved.files.items():
            (partial / name).write_bytes(text.encode())
        if also is not None:
            also(partial)

    return storage.save(trajectory, directory, resolved.text, overwrite=overwrite, also=write)


def plot(trajectory: Trajectory, directory: str | Path = "pictures") -> list[Path]:
    """Write the pictures of a run as PNG files; returns their paths."""
    from .plots import DISPLAYS, plot

    units = trajectory.scenario.notes.get("units", "SI")
    return plot(trajectory, directory, DISPLAYS[units])
