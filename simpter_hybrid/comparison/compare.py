"""``compare(scenario, candidates)``: every candidate's run against the exact one."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np

from ..scenario import Scenario
from ..trajectory import Trajectory
from .candidates import Candidate
from .events import changes, compare_releases, match
from .states import clutch_maps, points_of, states_at, stored_energy

#: Instants at which two runs are compared.
INSTANTS = 601

#: Changes of mode further apart than this are not the same one [s].
WINDOW = 0.02


@dataclass(frozen=True)
class Row:
    """One candidate against the exact run.

    Parameters
    ----------
    name, family : str
    size : float
        Band or width [rad/s], or step [s].
    status, message : str
        Of the candidate's run.
    final_error : float
        Largest error of a coordinate at the end of the shorter run [rad or m].
    path_error : float
        Largest distance of the tips (of the coordinates where there is no tip) at equal times [m].
    run_time_error : float
        Duration less the exact one [s].
    matched, missed, invented : int
        Stops and releases: the same ones, the exact run's that are absent, and others.
    largest_shift : float
        Largest error of a matched instant [s].
    drift : float
        Slip angle gathered by clutches while the candidate says that they are stuck [rad or m].
    energy_created : float
        Largest excess of the stored energy over what work and dissipation account for [J].
    clutch_drive : float
        Energy that clutches, which can only take it, have delivered [J].
    case_7, wrong, absent : int
        Releases out of a redundant stuck set in the exact run; those where other clutches slip;
        those without a release at that time.
    steps, rhs_evaluations : int
    cpu : float
        Processor time [s]; not part of ``as_dict``.
    """

    name: str
    family: str
    size: float
    status: str
    message: str
    final_error: float
    path_error: float
    run_time_error: float
    matched: int
    missed: int
    invented: int
    largest_shift: float
    drift: float
    energy_created: float | None
    clutch_drive: float
    case_7: int
    wrong: int
    absent: int
    steps: int
    rhs_evaluations: int
    cpu: float = field(default=0.0, compare=False)

    def as_dict(self) -> dict[str, Any]:
        """Ready for JSON; the same run gives the same numbers, so without times."""
        return {name: value for name, value in asdict(self).items() if name != "cpu"}


@dataclass(frozen=True)
class Comparison:
    """The exact run and all candidates' runs of one scenario."""

    scenario: Scenario
    reference: Trajectory
    runs: tuple[Trajectory, ...]
    rows: tuple[Row, ...]
    reference_cpu: float = 0.0

    def as_dict(self) -> dict[str, Any]:
        """Ready for JSON."""
        exact = self.reference
        return {
            "scenario": self.scenario.name,
            "exact": {
                "status": exact.status, "message": exact.message, "t_end": exact.t_end,
                "changes": len(changes(exact, exact.t_end)), **exact.statistics,
            },
            "window": WINDOW,
            "rows": [row.as_dict() for row in self.rows],
        }  # fmt: skip


def compare(
    scenario: Scenario,
    candidates: Sequence[Candidate],
    reference: Trajectory | None = None,
    progress: Callable[[str], None] | None = None,
) -> Comparison:
    """Run a scenario exactly and with every candidate, and measure the differences.

    Parameters
    ----------
    scenario : Scenario
    candidates : sequence of Candidate
    reference : Trajectory, optional
        The exact run, if it is at hand.
    progress : callable, optional
        Told the name of every run before it begins.

    Returns
    -------
    Comparison

    Raises
    ------
    RuntimeError
        If the exact run fails: there is nothing to compare with.
    """
    tell = progress or (lambda name: None)
    start = time.process_time()
    if reference is None:
        from ..engine import simulate

        tell("exact")
        reference = simulate(scenario)
    cpu = time.process_time() - start
    if reference.status == "failed":
        raise RuntimeError(f"the exact run of {scenario.name} failed: {reference.message}")
    runs, rows = [], []
    for candidate in candidates:
        tell(candidate.name)
        start = time.process_time()
        run = candidate.run(scenario)
        rows.append(measure(reference, run, candidate, time.process_time() - start))
        runs.append(run)
    return Comparison(scenario, reference, tuple(runs), tuple(rows), cpu)


def measure(reference: Trajectory, run: Trajectory, candidate: Candidate, cpu: float = 0.0) -> Row:
    """Differences of one run from the exact one."""
    scenario = reference.scenario
    until = min(reference.t_end, run.t_end)
    times = np.linspace(0.0, until, INSTANTS)
    mine, exact = states_at(run, times), states_at(reference, times)
    n = scenario.device.n
    apart = np.abs(points_of(scenario, mine) - points_of(scenario, exact))
    tips = "tip" in scenario.device.functions()
    distance = np.hypot(apart[:, 0], apart[:, 1]) if tips else apart.max(axis=1)
    found = match(changes(reference, until), changes(run, until), WINDOW)
    released = compare_releases(reference, run, WINDOW)
    created, drive = energy_faults(scenario, mine)
    return Row(
        name=candidate.name, family=candidate.family, size=candidate.size, status=run.status,
        message=run.message, final_error=float(np.abs(mine - exact)[-1, :n].max()),
        path_error=float(distance.max()), run_time_error=run.t_end - reference.t_end,
        matched=len(found.pairs), missed=len(found.missed), invented=len(found.invented),
        largest_shift=found.largest_shift, drift=drift(run), energy_created=created,
        clutch_drive=drive, case_7=len(released),
        wrong=sum(r.other is not None and r.other != r.reference for r in released),
        absent=sum(r.other is None for r in released), steps=run.statistics.get("steps", 0),
        rhs_evaluations=run.statistics.get("rhs_evaluations", 0), cpu=cpu,
    )  # fmt: skip


def energy_faults(scenario: Scenario, states: np.ndarray) -> tuple[float | None, float]:
    """Energy out of nothing, and energy out of clutches [J]."""
    m = scenario.device.m
    at = states.shape[1] - m - 2
    taken = states[:, at + 2 :]
    drive = float(-np.minimum(np.diff(taken, axis=0), 0.0).sum() + 0.0)
    stored = stored_energy(scenario, states)
    if stored is None:
        return None, drive
    excess = stored - stored[0] - states[:, at] - states[:, at + 1] + taken.sum(axis=1)
    return float(max(excess.max(), 0.0)), drive


def drift(run: Trajectory) -> float:
    """Slip angle gathered by clutches while the run says that they are stuck [rad or m].

    Reversals inside a segment cancel.
    """
    device, n = run.scenario.device, run.scenario.device.n
    starts, ends = run.segment_t[:, 0], run.segment_t[:, 1]
    if device.constant_clutch_map:
        first, last = states_at(run, starts), states_at(run, ends)
        maps = clutch_maps(run.scenario, first)
        slipped = np.einsum("kij,kj->ki", maps, (last - first)[:, :n])
        return float(np.abs(slipped[run.mode == 0]).sum())
    # A map that changes makes of a slip no difference of angles: its rate is integrated by steps.
    edges = np.unique(np.concatenate([starts, ends, run.step_t[run.step_t < run.t_end]]))
    middle, half = 0.5 * (edges[1:] + edges[:-1]), 0.5 * np.diff(edges)
    segment = np.searchsorted(starts, middle, side="right") - 1
    slipped = np.zeros((len(starts), device.m))
    for x, weight in zip(*np.polynomial.legendre.leggauss(4), strict=True):
        states = states_at(run, middle + x * half)
        rates = np.einsum("kij,kj->ki", clutch_maps(run.scenario, states), states[:, n : 2 * n])
        np.add.at(slipped, segment, weight * half[:, None] * rates)
    return float(np.abs(slipped[run.mode == 0]).sum())
