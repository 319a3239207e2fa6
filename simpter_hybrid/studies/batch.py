"""Many runs of the line, measured on a grid by the compiled engine, behind a plain list."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields

import numpy as np

from ..compiled import events_of
from ..ensemble import Rows, run_part
from ..kernel.records import STATUS, STOPPED
from ..known_units import INCH
from ..machine_code.program import Program, Results
from ..scenario import Scenario
from ..sweeps.batch import joined, structure
from ..sweeps.tip_motion import tip_motion

#: Step of the grid on which runs are measured [s].
STEP = 2e-3


@dataclass(frozen=True)
class Measured:
    """Measures of runs, (cases,), in the thesis's units where it has some.

    Parameters
    ----------
    reached : ndarray of bool
        Whether the run ended at its stop line.
    time : ndarray
        Duration [s].
    error, worst : ndarray
        Distance from the line, averaged along the path (44), and at most [in].
    jerk : ndarray
        Time average of the change of acceleration between instants 2 ms apart (46) [in/s^3]; a
        jump counts with its full size, so that it tends to the total variation per second.
    following : ndarray
        Rms difference of clutch torque and desired torque where one is desired [N m].
    work : ndarray
        Work of the hand [J].
    stops : ndarray
        How often a clutch came to rest or let go.
    """

    reached: np.ndarray
    time: np.ndarray
    error: np.ndarray
    worst: np.ndarray
    jerk: np.ndarray
    following: np.ndarray
    work: np.ndarray
    stops: np.ndarray

    def part(self, which) -> Measured:
        """Some of the runs."""
        return Measured(*(getattr(self, f.name)[which] for f in fields(self)))


def line_measures(scenarios: Sequence[Scenario]):
    """The function of ``ensemble(measure=...)`` for these runs of the linkage along their lines."""
    base = scenarios[0]
    desired = [k for k, name in enumerate(base.text.a.held) if name.startswith("desired")]
    names = base.parameter_names()
    values = np.array([s.parameter_values() for s in scenarios])
    selector = next(k for k, (c, _) in enumerate(base.controllers) if hasattr(c, "y"))
    path_y = values[:, names.index(f"controller.{selector + 1}.y"), None]
    sizes = base.sizes()
    m, work = sizes["m"], 2 * sizes["n"] + sizes["m"] + sizes["nz"]

    def measure(rows: Rows, end: np.ndarray, t_end: np.ndarray) -> dict[str, np.ndarray]:
        each = zip(scenarios, rows.q, rows.qd, rows.qdd, strict=True)
        tip, acceleration = map(np.array, zip(*(tip_motion(*of) for of in each), strict=True))
        error = np.abs(tip[..., 1] - path_y) / INCH
        chord = np.hypot(*np.moveaxis(np.diff(tip, axis=1), -1, 0))
        length = np.nansum(chord, axis=1)
        weighted = np.nansum(0.5 * (error[:, 1:] + error[:, :-1]) * chord, axis=1)
        change = np.linalg.norm(np.diff(acceleration, axis=1), axis=-1)
        wanted = rows.held[..., [m + k for k in desired]]
        off = np.where(wanted > 0.0, np.abs(rows.tau[..., : len(desired)]) - wanted, np.nan)
        with np.errstate(invalid="ignore"):
            return {
                "error": weighted / length,
                "worst": np.nanmax(error, axis=1),
                "jerk": np.nansum(change, axis=1) / t_end / INCH,
                "following": np.sqrt(np.nanmean(np.square(off), axis=(1, 2))),
                "work": end[:, work],
            }

    return measure


def measured(scenarios: Sequence[Scenario], chunk: int = 32) -> Measured:
    """Run and measure; scenarios of one structure are run together, in any order.

    Raises
    ------
    CompiledUnavailable
    """
    programs = [Program(s) for s in scenarios]
    groups: dict[tuple, list[int]] = {}
    for k, program in enumerate(programs):
        groups.setdefault(structure(program), []).append(k)
    columns = {f.name: np.zeros(len(scenarios)) for f in fields(Measured)}
    for members in groups.values():
        for first in range(0, len(members), chunk):
            part = members[first : first + chunk]
            for name, column in run_group([programs[k] for k in part]).items():
                columns[name][part] = column
    reached = columns.pop("reached") > 0.0
    return Measured(reached=reached, **columns)


def run_group(programs: list[Program]) -> dict[str, np.ndarray]:
    """Runs of one structure, that differ in numbers only."""
    scenarios = [program.scenario for program in programs]
    base = scenarios[0]
    grid = np.arange(int(base.t_end / STEP) + 1) * STEP
    found, taken = run_part(
        base, joined(programs), grid, line_measures(scenarios), False, False
    )  # fmt: skip
    runs = [(each, k) for each in found for k in range(each.done)]
    status = np.array([each.counts[k, STATUS] for each, k in runs])
    stops = np.array([stops_of(base, each, k) for each, k in runs])
    ends = np.concatenate([each.t for each in found])
    return {"reached": status == STOPPED, "time": ends, "stops": stops} | taken


def stops_of(scenario: Scenario, found: Results, case: int) -> int:
    """How often a clutch came to rest or let go in a case."""
    (first, _, _), (count, _, _) = found.kept(0, case), found.kept(case, case + 1)
    events = events_of(scenario, found.records["event_t"], found.records["event_i"], first, count)
    return sum(event.kind in ("slip stop", "breakaway") for event in events)
