"""The compiled engine: the kernel's own source and the assembled model as machine code.

Nothing is written twice: the kernel compiled is the source that the reference engine imports
(``compiling``), and the model's text is the one that the reference engine executes.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from .kernel import records
from .kernel.records import events_at_once
from .machine_code.program import Program, Results, Room
from .running import failures
from .running.blame import held_names
from .scenario import Scenario
from .trajectory import Event, Trajectory

#: Kinds of events in words, by the kernel's numbers (``records.STARTED`` and the following).
KINDS = ("start", "switched", "slip stop", "effect", "breakaway")


def simulate(scenario: Scenario, progress: Callable[[float], None] | None = None) -> Trajectory:
    """Run a scenario with the compiled engine; the same result as ``engine.simulate``.

    Parameters
    ----------
    scenario : Scenario
    progress : callable, optional
        As for ``engine.simulate``, in runs of more than some thousand steps. Where the record has
        no more room the run begins anew, so that instants may be told twice.

    Returns
    -------
    Trajectory
        Also when the run fails.

    Raises
    ------
    CompiledUnavailable
        If llvmlite is missing or the model is too large; the message names the reference engine.
    KeyboardInterrupt
        By Ctrl-C, soon, without `progress`; with one what there was is the result.
    """
    heed = progress or (lambda t: None)
    found = Program(scenario).once(Room(1000, 1000, 2000), heed, record=True)
    if found.halted and progress is None:
        raise KeyboardInterrupt  # of whoever runs one after another, not of this run
    return trajectory(scenario, found)


def outcome(
    scenario: Scenario, status: int, t: float, why: int, y: Sequence[float] | None = None
) -> tuple[str, str]:
    """Status and message of a run from the kernel's codes.

    Parameters
    ----------
    scenario : Scenario
    status : int
        0, or why the run ended (``kernel.records``).
    t : float
        Instant at which it ended [s].
    why : int
        Stop condition or clutch that ended it, from 0; of an input as `kernel.rules.not_held`.
    y : sequence of float (ny,), optional
        State there.
    """
    if status == 0:
        return "finished", "reached t_end"
    if status == records.HALTED:
        return "interrupted", f"interrupted at t = {t!r} s"
    if status == records.NOT_HELD:
        return "failed", sample_failure(scenario, t, why)
    if status == records.TOO_SHORT:
        return "failed", f"at t = {t!r} s {failures.stands_still(scenario, t, y)}"
    if status < records.STOPPED or status >= records.MANY_EVENTS:
        return "failed", f"at t = {t!r} s {_why(scenario, status, why)}"
    word = "stopped" if status == records.STOPPED else "failed"
    return word, f"{scenario.stops[why].reason} at t = {t!r} s"  # type: ignore[attr-defined]


def sample_failure(scenario: Scenario, t: float, why: int) -> str:
    """What a sample held that is no finite number; names the controller if it is the only one.

    Parameters
    ----------
    scenario : Scenario
    t : float
        Instant of the sample [s].
    why : int
        As `kernel.rules.not_held`.
    """
    place, value = divmod(why, len(records.NO_FINITE))
    wrong = f"{held_names(scenario)[place]} is {records.NO_FINITE[value]}"
    source = "the engine 'reference' names the controller that it came from"
    if len(scenario.controllers) == 1:
        source = "it came from controller 1, step"
    return f"{failures.at_sample(t, wrong)}; {source}"


def _why(scenario: Scenario, status: int, which: int) -> str:
    if status == records.INCOMPATIBLE:
        return failures.incompatible(which, "others")
    words = failures.NO_MODE | {
        records.NO_NUMBER: failures.NOT_FINITE,
        records.ZENO: failures.at_once(events_at_once(scenario.device.m)),
        records.MANY_EVENTS: failures.too_many(scenario.event_limit),
        records.MANY_STEPS: failures.MANY_STEPS,
    }
    return words[status]


def events_of(
    scenario: Scenario, event_t: np.ndarray, event_i: np.ndarray, first: int, count: int
) -> tuple[Event, ...]:
    """Events ``first`` to ``first + count`` of a record.

    Parameters
    ----------
    scenario : Scenario
    event_t : ndarray (2 events,)
        Instant [s] and margin [N m or N] of every event.
    event_i : ndarray of int ((2 m + 1) events,)
        Kind (`KINDS`), modes before and modes after.
    first, count : int
        The first event wanted, from 0, and how many.
    """
    m = scenario.device.m
    case = scenario.device.case_of
    found = []
    for k in range(first, first + count):
        row = event_i[k * (2 * m + 1) : (k + 1) * (2 * m + 1)].tolist()
        before, after = tuple(row[1 : m + 1]), tuple(row[m + 1 :])
        changed = tuple(i + 1 for i in range(m) if before[i] != after[i])
        t, margin = event_t[2 * k : 2 * k + 2].tolist()
        found.append(
            Event(t, KINDS[row[0]], changed, before, after, case(before), case(after), margin)
        )
    return tuple(found)


def trajectory(
    scenario: Scenario, found: Results, case: int = 0, offsets: tuple[int, int, int] = (0, 0, 0)
) -> Trajectory:
    """A case's record as a ``Trajectory``; ``offsets``: where its events, segments, steps begin.

    Parameters
    ----------
    scenario : Scenario
    found : Results
        Of a call with ``record=True``.
    case : int
        From 0, within `found`.
    offsets : (int, int, int)
        ``found.kept(0, case)``.
    """
    z = scenario.sizes()
    m, ny = z["m"], z["ny"]
    status, why = (int(v) for v in found.counts[case, : records.COUNTS])
    events, segments, steps = found.kept(case, case + 1)
    e0, k0, s0 = offsets
    r = found.records

    def table(array: np.ndarray, first: int, count: int, *shape: int) -> np.ndarray:
        width = int(np.prod(shape))
        return array[first * width : (first + count) * width].reshape(count, *shape).copy()

    word, message = outcome(scenario, status, float(found.t[case]), why, found.end[case])
    logged = events_of(scenario, r["event_t"], r["event_i"], e0, events)
    if status in (records.MANY_EVENTS, records.ZENO):
        message += f"; {failures.last_events(logged)}"
    return Trajectory(
        step_t=table(r["step_t"], s0, steps),
        step_h=table(r["step_h"], s0, steps),
        step_y=table(r["step_y"], s0, steps, ny),
        step_f=table(r["step_f"], s0, steps, z["nf"], ny),
        step_segment=table(r["step_segment"], s0, steps),
        segment_t=table(r["segment_t"], k0, segments, 2),
        mode=table(r["modes"], k0, segments, m),
        gate=table(r["gates"], k0, segments, m),
        held=table(r["helds"], k0, segments, z["nh"]),
        dmode=table(r["dmodes"], k0, segments, z["nd"]),
        end=found.end[case].copy(),
        events=logged,
        status=word,
        message=message,
        statistics={"segments": segments, "steps": steps, "events": events},
        engine="compiled",
        scenario=scenario,
    )
