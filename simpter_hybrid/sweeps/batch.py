"""Scenarios of one structure run by the compiled engine in one call, each to the same bits."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from ..compiled import trajectory
from ..ensemble import Rows, run_part
from ..machine_code.program import KINDS, Cases, Program
from ..measuring.metrics import instants
from ..scenario import Scenario
from ..trajectory import Trajectory
from .brief import after

#: Rows of output kept at a time, in bytes.
MOST_BYTES = 64_000_000


def structure(program: Program) -> tuple:
    """All that one call of the compiled kernel has in common; two of a kind can share a call.

    Parameters
    ----------
    program : Program

    Returns
    -------
    tuple
        Hashable.
    """
    s = program.scenario
    tolerances = (s.method, s.rtol, s.atol, s.max_step)
    options = (s.t_end, s.period, *tolerances, s.event_limit, len(s.rec))
    kinds = tuple(tuple(program.switching[name]) for name in KINDS)
    numbers = tuple(sorted(program.numbers.items()))
    known = (tuple(program.breaks), tuple(program.jumps))
    return (s.text.finish(), numbers, kinds, known, options)


def joined(programs: Sequence[Program]) -> Cases:
    """The cases of programs of one structure, one behind the other.

    Parameters
    ----------
    programs : sequence of Program
        One at least.

    Returns
    -------
    Cases
        In that order, a case each.
    """
    own = [program.cases(1) for program in programs]
    same = all(np.array_equal(own[0].data, case.data) for case in own)

    def column(name: str) -> np.ndarray:
        return np.concatenate([getattr(case, name) for case in own])

    data = own[0].data if same else np.stack([case.data for case in own])
    four = (column(name) for name in ("parameters", "starts", "delay", "threshold"))
    parameters, starts, delay, threshold = four
    return Cases(parameters, starts, delay, threshold, data)


def run_batch(scenarios: Sequence[Scenario], step: float) -> Iterator[tuple[int, Trajectory, Rows]]:
    """Run scenarios; yields the number, the run and its rows at ``instants`` of each, in any order.

    Parameters
    ----------
    scenarios : sequence of Scenario
    step : float
        Sampling step of the rows [s].

    Raises
    ------
    CompiledUnavailable
    """
    programs = [Program(scenario) for scenario in scenarios]
    groups: dict[tuple, list[int]] = {}
    for k, program in enumerate(programs):
        groups.setdefault(structure(program), []).append(k)
    for members in groups.values():
        grid = instants(scenarios[members[0]].t_end, step)
        room = max(1, MOST_BYTES // (8 * len(grid) * programs[members[0]].width))
        for first in range(0, len(members), room):
            part = members[first : first + room]
            yield from run_group([programs[k] for k in part], part, grid)


def run_group(
    programs: list[Program], numbers: list[int], grid: np.ndarray
) -> Iterator[tuple[int, Trajectory, Rows]]:
    """Run programs of one structure in one call.

    Parameters
    ----------
    programs : list of Program
    numbers : list of int
        What is yielded for each of them.
    grid : ndarray (g,)
        Instants [s], see ``instants``.

    Yields
    ------
    (int, Trajectory, Rows)
        Number, dense run, and its rows after what happens at the instants.
    """
    base = programs[0].scenario
    cases = joined(programs)
    found, _ = run_part(base, cases, after(grid, base.t_end), None, True, False)
    at = 0
    for results in found:
        for k in range(len(results.t)):
            offsets = results.kept(0, k)
            own = programs[at].scenario
            run = trajectory(own, results, k, offsets)
            yield numbers[at], run, Rows.of(programs[at], grid, results.rows[k])
            at += 1
