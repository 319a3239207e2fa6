"""A run on disk: written whole or not at all, read back to the bit."""

from __future__ import annotations

import csv
import dataclasses
import io
import json
import zipfile
from collections import Counter
from collections.abc import Callable, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np

from ..explanation.explain import event_notes
from ..measuring.energy import energy_balance
from ..measuring.metrics import measures
from ..measuring.readings import readings_csv
from ..scenario import Scenario
from ..trajectory import Trajectory
from ..versions import own_version
from .archive import ABOUT, FORMAT, StoredRunError, read_archive
from .json_text import json_text, plain
from .run_directory import BESIDE, MARK, digests, run_directory
from .same_scenario import difference, difference_from, identity
from .scenario_file import parse

EVENT_COLUMNS = (
    "t", "kind", "clutches", "before", "after", "case_before", "case_after", "margin", "note"
)  # fmt: skip


def save(
    trajectory: Trajectory,
    directory: str | Path,
    scenario_text: str = "",
    *,
    files: Mapping[str, str] = MappingProxyType({}),
    overwrite: bool = False,
    also: Callable[[Path], None] | None = None,
) -> Path:
    """Write a run's files: scenario.toml, trajectory.npz, events.csv, summary.json, readings.csv.

    The same run gives the same bytes: no dates, no host, no compression that depends on a library.

    Parameters
    ----------
    trajectory : Trajectory
        The run to write.
    directory : path
        Made if needed; appears complete or not at all.
    scenario_text : str
        The resolved scenario as TOML; without it no ``scenario.toml`` is written.
    files : mapping
        Text of the further files that the scenario names, by their names.
    overwrite : bool
        Replace a directory that holds a run already.
    also : callable, optional
        Called with the directory to add further files (report, figures) before it gets its name.

    Raises
    ------
    RunDirectoryError
        If the directory is not empty, see ``run_directory.check_free``.
    """
    with run_directory(directory, overwrite) as partial:
        put_run(trajectory, partial, scenario_text, files)
        put_tables(trajectory, partial)
        if also is not None:
            also(partial)
        put_summary(trajectory, partial)
    return Path(directory)


def put_run(
    trajectory: Trajectory, directory: Path, scenario_text: str, files: Mapping[str, str]
) -> None:
    """Write what nothing else could be made of again: the scenario and the trajectory.

    Parameters
    ----------
    trajectory, scenario_text, files
        As for ``save``.
    directory : Path
        It exists.
    """
    if scenario_text:
        (directory / "scenario.toml").write_bytes(scenario_text.encode())
    for name, text in files.items():
        (directory / name).write_bytes(text.encode())
    (directory / MARK).write_bytes(trajectory_bytes(trajectory))


def put_tables(trajectory: Trajectory, directory: Path) -> None:
    """Write events.csv and, of a scenario with sensors, readings.csv."""
    (directory / "events.csv").write_bytes(events_csv(trajectory).encode())
    readings = trajectory.scenario.notes.get("readings")
    if readings is not None and len(trajectory.segment_t) > 0:
        (directory / "readings.csv").write_bytes(readings_csv(trajectory, readings).encode())


def put_summary(trajectory: Trajectory, directory: Path, measured: bool = True) -> None:
    """Write summary.json; without its measures it takes no time, however long the run.

    Parameters
    ----------
    trajectory : Trajectory
    directory : Path
        With the run's other files: digests of those beside them are told.
    measured : bool
        Whether measures and energy balance are taken.
    """
    beside = digests(directory)
    told = summary(trajectory, measured) | ({BESIDE: beside} if beside else {})
    new = directory / "summary.json.new"
    new.write_bytes(json_text(told).encode())
    new.replace(directory / "summary.json")


def load(directory: str | Path, scenario: Scenario | None = None) -> Trajectory:
    """Read a run back; it evaluates identically.

    Parameters
    ----------
    directory : path
        As written by ``save``.
    scenario : Scenario, optional
        The scenario that was run; read from ``scenario.toml`` when left out.

    Raises
    ------
    StoredRunError
        If files are missing or damaged, or the scenario is not the one that was run.
    InvalidInput
        If what ``scenario.toml`` says is no scenario any more.
    """
    directory = Path(directory)
    if scenario is None:
        scenario = _scenario_of(directory)
    stored = read_archive(directory / MARK)
    _refuse_if(_parameter_changed(scenario, stored.parameters), directory)
    _refuse_if(difference(scenario, stored.identity), directory)
    run = Trajectory(**stored.values, scenario=scenario)
    _refuse_if(difference_from(scenario, run), directory)
    return run


def _scenario_of(directory: Path) -> Scenario:
    file = directory / "scenario.toml"
    try:
        text = file.read_text(encoding="utf-8")
    except FileNotFoundError:
        raise StoredRunError(
            f"{directory} holds no scenario.toml (the run was not made from a file); "
            "pass the Scenario itself"
        ) from None
    except (OSError, UnicodeDecodeError) as error:
        raise StoredRunError(f"{file} cannot be read ({error}); run the scenario again") from error
    return parse(text, str(file), directory)


def _parameter_changed(scenario: Scenario, ran: Mapping[str, float]) -> str:
    given = dict(zip(scenario.parameter_names(), scenario.parameter_values(), strict=True))
    for name in [*ran, *given]:
        if ran.get(name) != given.get(name):
            return f"{name} is {given.get(name)}, but was {ran.get(name)} (SI)"
    return ""


def _refuse_if(changed: str, directory: Path) -> None:
    if changed:
        raise StoredRunError(
            f"the scenario is not the one that was run in {directory}: {changed}; give that one, "
            "or run this one anew"
        )


def trajectory_bytes(trajectory: Trajectory) -> bytes:
    """``trajectory.npz``: the arrays, and the rest as JSON; uncompressed, without time stamps."""
    scenario = trajectory.scenario
    about: dict[str, Any] = {
        "format": FORMAT,
        "parameters": dict(
            zip(scenario.parameter_names(), scenario.parameter_values(), strict=True)
        ),
        "scenario": identity(scenario),
    }
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_STORED) as archive:
        for f in dataclasses.fields(trajectory):
            value = getattr(trajectory, f.name)
            if isinstance(value, np.ndarray):
                member = io.BytesIO()
                kind = "<i8" if value.dtype.kind in "iu" else "<f8"
                np.lib.format.write_array(
                    member, np.ascontiguousarray(value, dtype=kind), version=(1, 0)
                )
                archive.writestr(zipfile.ZipInfo(f"{f.name}.npy"), member.getvalue())
            elif f.name == "events":
                about["events"] = [dataclasses.asdict(event) for event in value]
            elif f.name != "scenario":
                about[f.name] = value
        archive.writestr(zipfile.ZipInfo(ABOUT), json.dumps(about, indent=1, default=plain))
    return buffer.getvalue()


def events_csv(trajectory: Trajectory) -> str:
    """The event table; numbers in full, modes as BACKWARD -1, STICK 0, FORWARD 1, FREE 2."""
    out = io.StringIO()
    table = csv.writer(out, lineterminator="\n")
    units = {"t": "t [s]", "margin": f"margin [{trajectory.scenario.device.surface_units[1]}]"}
    table.writerow([units.get(column, column) for column in EVENT_COLUMNS])
    notes = event_notes(trajectory)
    for event, note in zip(trajectory.events, notes, strict=True):
        row = []
        for column in EVENT_COLUMNS:
            value = note if column == "note" else getattr(event, column)
            row.append(" ".join(map(str, value)) if isinstance(value, tuple) else value)
        table.writerow(row)
    return out.getvalue()


def state_names(scenario: Scenario) -> list[str]:
    """Names of the entries of the state vector."""
    device, clutches = scenario.device, range(1, scenario.device.m + 1)
    return [
        *device.coordinates,
        *(f"speed of {name}" for name in device.coordinates),
        *(f"excitation_{i}" for i in clutches),
        *scenario.text.a.states,
        "work of the load",
        "work of the effects",
        *(f"dissipated_{i}" for i in clutches),
    ]


@np.errstate(over="ignore", invalid="ignore")  # what overflows is null in the result
def summary(trajectory: Trajectory, measured: bool = True) -> dict[str, Any]:
    """What ``summary.json`` holds: outcome, final state, counts; measures and energy balance.

    The latter two are None of a run that did not begin, and where they are not ``measured``.

    Parameters
    ----------
    trajectory : Trajectory
    measured : bool
    """
    scenario = trajectory.scenario
    began = trajectory.t_end > 0.0
    return {
        "format": FORMAT,
        "simpter_hybrid": own_version(),
        "scenario": scenario.name,
        "engine": trajectory.engine,
        "status": trajectory.status,
        "message": trajectory.message,
        "run_time_s": trajectory.t_end,
        "final_state_si": dict(zip(state_names(scenario), trajectory.end.tolist(), strict=True)),
        "event_kinds": dict(sorted(Counter(event.kind for event in trajectory.events).items())),
        "statistics": dict(trajectory.statistics),
        "metrics": measures(trajectory).as_dict() if began and measured else None,
        "energy": energy_balance(trajectory).as_dict() if began and measured else None,
    }
