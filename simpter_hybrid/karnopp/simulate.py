"""``simulate(scenario, band, ...) -> Trajectory``: Karnopp's model as an engine."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple, Protocol

import numpy as np

from ..running.blame import part_failure
from ..scenario import Scenario
from ..trajectory import Event, Trajectory
from . import records
from .gathering import (
    PART_FAILED,
    Ended,
    empty_record,
    events_of,
    outcome,
    statistics,
    trajectory,
)
from .run import FULL, run
from .settings import Settings

#: Room for the steps of one run: about 1 GB of dense output for PTER.
MOST_STEPS = 2_400_000


class GridRun(NamedTuple):
    """A run of which only the states at given instants and the events are kept.

    ``states`` (len(grid), ny); rows after the end of the run (``t_end``) hold the final state.
    """

    states: np.ndarray
    end: np.ndarray
    t_end: float
    events: tuple[Event, ...]
    status: str
    statistics: dict[str, int]
    scenario: Scenario


def simulate(scenario: Scenario, band: float = 1e-3, **settings: Any) -> Trajectory:
    """Run a scenario with Karnopp's friction model.

    Parameters
    ----------
    scenario : Scenario
    band : float
        Half width of the band of slip speeds in which a clutch sticks [rad/s or m/s].
    **settings
        The other fields of ``Settings``: ``solver``, ``step``, ``rules``, ``rtol``, ``atol``,
        ``max_step``, ``compiled``.

    Returns
    -------
    Trajectory
        With cubic Hermite steps. A clutch counts as stuck while its slip is inside the band and
        its torque is below breakaway; changes of mode are logged at ends of steps. ``status`` is
        ``failed`` where the state left the finite numbers, a part raised an exception, or the
        record outgrew its limit.

    Raises
    ------
    ValueError
        For settings that make no sense.

    Notes
    -----
    Source: thesis 3.2 and Appendix A; Karnopp 1985. Stop conditions are located inside the last
    step, switching instants of clutches are met exactly: both are kinder than SIMULINK was.
    Guards of effects (a contact, a limit of a slew) are looked at when a step is finished, and act
    there, so that they are late by up to a step. Friction of bristles never sticks here either.
    """
    chosen = Settings(band=band, **settings)
    o = chosen.options(scenario)
    expected = scenario.t_end / (chosen.fixed_step if o.variable == 0 else o.max_step)
    ready = prepare(scenario, chosen)
    steps, segments = int(min(1.2 * expected, MOST_STEPS)) + 4000, 4000
    while True:
        rec = empty_record(scenario, steps, segments, [])
        ended = ready.drive(o, rec)
        if ended.status != FULL or max(steps, segments) >= MOST_STEPS:
            name = f"karnopp, band {band:g}, {chosen.solver} step"
            return trajectory(scenario, rec, ended, name)
        steps, segments = min(4 * steps, MOST_STEPS), 4 * segments


def on_grid(ready: Prepared, grid: Sequence[float], settings: Settings) -> GridRun:
    """Run a scenario with Karnopp's model, keeping only the states at ``grid`` [s].

    However many steps it takes: they need no memory.

    Parameters
    ----------
    ready : Prepared
        What `prepare` gave.
    grid : sequence of float
        Rising.
    settings : Settings
    """
    scenario = ready.scenario
    o = settings.options(scenario, record=False)
    segments = 4000
    while True:
        rec = empty_record(scenario, 0, segments, grid)
        ended = ready.drive(o, rec)
        if ended.status != FULL or segments > MOST_STEPS:
            break
        segments *= 8
    states = rec.rows.reshape(-1, len(ended.y))
    states[int(rec.n[records.GRID]) :] = ended.y
    word, _ = outcome(scenario, ended)
    return GridRun(
        states, np.array(ended.y), ended.t, events_of(scenario, rec), word, statistics(rec),
        scenario,
    )  # fmt: skip


class Prepared(Protocol):
    """A scenario ready for runs with any settings."""

    scenario: Scenario

    def drive(self, o: records.Options, rec: records.Record) -> Ended:
        """One run into ``rec``.

        Parameters
        ----------
        o : Options
            What ``Settings.options`` gave.
        rec : Record
            Written.
        """


def prepare(scenario: Scenario, settings: Settings) -> Prepared:
    """The scenario ready for runs, compiled or not.

    Parameters
    ----------
    scenario : Scenario
    settings : Settings
        Of which only ``compiled`` counts.
    """
    if settings.compiled:
        from .compiled import Compiled

        return Compiled(scenario)
    return Interpreted(scenario)


class Interpreted:
    """A scenario ready for runs in Python, on lists."""

    def __init__(self, scenario: Scenario) -> None:
        self.scenario = scenario
        md = scenario.python_model()
        self.md = records.Model(**{name: getattr(md, name) for name in records.Model._fields})

    def drive(self, o: records.Options, rec: records.Record) -> Ended:
        """One run into ``rec``."""
        md = self.md
        y, shared = self.scenario.initial(list_of_reals, list_of_integers)
        w = records.work_arrays(
            shared, md.n, md.m, md.ny, md.ng, list_of_reals, list_of_integers
        )  # fmt: skip
        breaks = list(self.scenario.breakpoints())
        try:
            status, t, which = run(md, o, breaks, w, y, rec)
        except Exception as error:  # whatever a user's part does
            said = part_failure(error, w.reached[0])
            if said is None:
                raise
            return Ended(PART_FAILED, w.reached[0], -1, y, said)
        return Ended(status, t, which, y)


def list_of_reals(k: int) -> list[float]:
    """Zeros."""
    return [0.0] * k


def list_of_integers(k: int) -> list[int]:
    """Zeros."""
    return [0] * k
