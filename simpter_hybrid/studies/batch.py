"""Many runs of the line, measured on a grid: the compiled engine's ensemble behind a plain list."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields

import numpy as np

from ..ensemble import Rows, ensemble
from ..kernel.records import STOPPED
from ..known_units import INCH
from ..scenario import Scenario
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
    """Run and measure; scenarios of one model are run together, in any order.

    Raises
    ------
    CompiledUnavailable
    """
    groups: dict[tuple, list[int]] = {}
    for k, s in enumerate(scenarios):
        key = (s.text.finish(), s.period, s.t_end, len(s.breakpoints()))
        groups.setdefault(key, []).append(k)
    columns = {f.name: np.zeros(len(scenarios)) for f in fields(Measured)}
    for members in groups.values():
        for first in range(0, len(members), chunk):
            part = members[first : first + chunk]
            for name, column in run_group([scenarios[k] for k in part]).items():
                columns[name][part] = column
    reached = columns.pop("reached") > 0.0
    return Measured(reached=reached, **columns)


def run_group(scenarios: list[Scenario]) -> dict[str, np.ndarray]:
    """Runs of one model that differ in numbers only."""
    base = scenarios[0]
    grid = np.arange(int(base.t_end / STEP) + 1) * STEP
    found = ensemble(base, differing(scenarios), grid=grid, measure=line_measures(scenarios))
    kinds = [[e.kind for e in found.events(k)] for k in range(len(found))]
    stops = [sum(kind in ("slip stop", "breakaway") for kind in each) for each in kinds]
    whole = {"reached": found.status == STOPPED, "time": found.t, "stops": np.array(stops)}
    return whole | found.measures


def differing(scenarios: list[Scenario]) -> dict[str, np.ndarray]:
    """Columns for ``ensemble(vary=...)``: what differs between scenarios of one model."""
    base = scenarios[0]
    values = np.array([s.parameter_values() for s in scenarios])
    columns = {
        name: values[:, k]
        for k, name in enumerate(base.parameter_names())
        if np.ptp(values[:, k]) > 0.0
    }
    for j, name in enumerate(base.device.coordinates):
        columns[f"q.{name}"] = np.array([s.q[j] for s in scenarios])
        columns[f"qd.{name}"] = np.array([s.qd[j] for s in scenarios])
    return columns
