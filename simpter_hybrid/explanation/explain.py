"""Why did it slip here? The event nearest to an instant, taken apart."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..kernel.instant import FACET, NO_CAUSE, PENDING, SLIP_STOP
from ..kernel.records import BACKWARD, FORWARD, FREE, ON
from ..measuring.evaluation import Evaluation, states
from ..trajectory import Event, Trajectory
from .explanation_text import text_of
from .facets import Facet, facets_at
from .successors import CONSISTENT, Candidate, Round, replay, successors

#: The segments before and after an event; None at the ends of the run.
Around = tuple[int | None, int | None]


@dataclass(frozen=True)
class Explanation:
    """What ``explain`` returns; ``str()`` gives the text for a reader.

    Parameters
    ----------
    unit : str
        SI unit of torques, or of forces.
    asked : float
        Instant asked for [s].
    t : float
        Instant explained [s]: that of the event nearest to it, or ``asked`` without any event.
    event : Event or None
    mode, excitation : tuple, (m,)
        Modes, and excitations [V], just before.
    facets : tuple of Facet
        Of the set stuck just before, the least margin first.
    redundant : tuple of int
        Clutches (from 1) whose holding torque was not unique.
    rounds : tuple of Round
        How the rule found the modes that followed.
    candidates : tuple of Candidate
        Every successor tried; empty if nothing was to be decided or there were too many.
    now : tuple of Facet
        Facets at ``asked``, where that is not the event's instant.
    mode_now : tuple of int, (m,)
        Modes at ``asked``.
    in_turn : bool
        Several broke away at this instant, one after another: the rounds are the first one's.
    """

    unit: str
    asked: float
    t: float
    event: Event | None
    mode: tuple[int, ...]
    excitation: tuple[float, ...]
    facets: tuple[Facet, ...]
    redundant: tuple[int, ...]
    rounds: tuple[Round, ...]
    candidates: tuple[Candidate, ...]
    now: tuple[Facet, ...]
    mode_now: tuple[int, ...]
    in_turn: bool = False

    @property
    def undecided(self) -> tuple[int, ...]:
        """Clutches (from 1) at zero slip that did not just go on holding: a decision was taken."""
        if self.event is None or not self.rounds:
            return ()
        before, after = self.event.before, self.event.after
        return tuple(i for i in self.rounds[0].zero if before[i - 1] != 0 or after[i - 1] != 0)

    @property
    def others(self) -> tuple[Candidate, ...]:
        """Consistent successors other than the one that followed: the event was ambiguous.

        Those that differ only in clutches that went on holding are no alternatives: with a
        breakaway torque above the slip torque whatever is stuck might as well slip.
        """
        if self.event is None:
            return ()
        after = self.event.after
        return tuple(
            c
            for c in self.candidates
            if c.verdict == CONSISTENT
            and any(c.mode[i - 1] != after[i - 1] for i in self.undecided)
        )

    @property
    def note(self) -> str:
        """A short note for event logs: which other successors were consistent; '' if none."""
        if not self.others:
            return ""
        return "ambiguous, others were consistent: " + "; ".join(
            " ".join(str(mode) for mode in c.mode) for c in self.others
        )

    def __str__(self) -> str:
        return text_of(self)


def explain(trajectory: Trajectory, t: float) -> Explanation:
    """Explain the event nearest to ``t`` [s].

    Raises
    ------
    ValueError
        If ``t`` is outside the run.
    """
    trajectory.state(t)
    if not trajectory.events:
        return _without_event(trajectory, t)
    nearest = min(range(len(trajectory.events)), key=lambda i: abs(trajectory.events[i].t - t))
    found = explain_event(trajectory, nearest)
    view = Evaluation(trajectory)
    k = trajectory.segment_at(t)
    now = () if t == found.t else facets_at(view, k, t)[0]
    return dataclasses.replace(found, asked=t, now=now, mode_now=tuple(trajectory.mode[k].tolist()))


def explain_event(
    trajectory: Trajectory, index: int, around: Sequence[Around] | None = None
) -> Explanation:
    """Explain the run's event number ``index`` (from 0).

    Whoever explains many hands in ``around``, ``segments_around(trajectory)``: it takes a look at
    the whole run.
    """
    event = trajectory.events[index]
    before, after = (segments_around(trajectory) if around is None else around)[index]
    view = Evaluation(trajectory)
    facets: tuple[Facet, ...] = ()
    redundant: tuple[int, ...] = ()
    cause, which, margin = NO_CAUSE, 0, 0.0
    excitation: tuple[float, ...] = ()
    if before is not None:
        facets, redundant = facets_at(view, before, event.t)
        y_before = states(trajectory, np.array([event.t]), np.array([before]))[0].tolist()
        cause, which, margin = _cause(view, event, y_before)
        excitation = _excitation(trajectory, before, event.t)
    y = _state_after(trajectory, event.t, after)
    rounds, candidates = _decision(view, event, after, y, (cause, which, margin))
    last = len(trajectory.mode) if after is None else after
    return Explanation(
        unit=trajectory.scenario.device.surface_units[1],
        asked=event.t,
        t=event.t,
        event=event,
        mode=event.before,
        excitation=excitation,
        facets=facets,
        redundant=redundant,
        rounds=tuple(rounds),
        candidates=tuple(candidates),
        now=(),
        mode_now=event.after,
        in_turn=before is not None and last - before > 1,
    )


def _decision(view, event, after, y, cause) -> tuple[list[Round], list[Candidate]]:
    """Replay the rule from the modes before, then try every successor."""
    md, w, run = view.md, view.w, view.trajectory
    source = len(run.mode) - 1 if after is None else after
    gate = run.gate[source].tolist()
    for i in range(md.m):
        w.mode[i] = event.before[i]
        if after is not None:
            w.gate[i] = gate[i]
            if gate[i] == ON and event.before[i] == FREE:
                w.mode[i] = PENDING
    if after is not None:
        w.held[: run.held.shape[1]] = run.held[after].tolist()
        w.dmode[: run.dmode.shape[1]] = run.dmode[after].tolist()
    rounds = replay(view, event.t, y, *cause)
    zero = rounds[0].zero
    return rounds, successors(view, event.t, y, rounds[0].after, zero) if zero else []


def _without_event(trajectory: Trajectory, t: float) -> Explanation:
    view = Evaluation(trajectory)
    k = trajectory.segment_at(t)
    facets, redundant = facets_at(view, k, t)
    mode = tuple(trajectory.mode[k].tolist())
    excitation = _excitation(trajectory, k, t)
    unit = trajectory.scenario.device.surface_units[1]
    return Explanation(unit, t, t, None, mode, excitation, facets, redundant, (), (), facets, mode)


def segments_around(trajectory: Trajectory) -> list[Around]:
    """For every event the segments before and after it.

    Between those of a breakaway may lie some without duration: several are one event.
    """
    found: list[Around] = []
    modes = [tuple(row) for row in trajectory.mode.tolist()]
    starts = trajectory.segment_t[:, 0].tolist()
    count, k = len(modes), 0
    for event in trajectory.events:
        before = None
        while k < count:
            if starts[k] == event.t and modes[k] == event.after:
                before = k - 1
                while before > 0 and modes[before] != event.before and starts[before] == event.t:
                    before -= 1
                if before < 0 or modes[before] == event.before:
                    break
            k += 1
        if k == count:
            found.append((count - 1, None))
        else:
            found.append((before if k > 0 else None, k))
            k += 1
    return found


def _excitation(trajectory: Trajectory, segment: int, t: float) -> tuple[float, ...]:
    device = trajectory.scenario.device
    y = states(trajectory, np.array([t]), np.array([segment]))[0]
    return tuple(y[2 * device.n : 2 * device.n + device.m].tolist())


def _state_after(trajectory: Trajectory, t: float, after: int | None) -> list[float]:
    if after is None:
        return trajectory.end.tolist()
    return states(trajectory, np.array([t]), np.array([after]))[0].tolist()


def _cause(view: Evaluation, event: Event, y: list[float]) -> tuple[int, int, float]:
    """Which guard fell, seen from the side before: (cause, clutch or facet, margin)."""
    if event.kind == "breakaway":
        margins = view.margins()
        if margins:
            return FACET, int(np.argmin(margins)), min(event.margin, 0.0)
    if event.kind == "slip stop":
        slip = view.slip(y)
        slipping = [i for i, mode in enumerate(view.mode) if mode in (FORWARD, BACKWARD)]
        if slipping:
            return SLIP_STOP, min(slipping, key=lambda i: abs(slip[i])), 0.0
    return NO_CAUSE, 0, 0.0


def event_notes(trajectory: Trajectory) -> tuple[str, ...]:
    """A note for every event: the engine's own, and whether other successors were consistent."""
    notes = []
    around = segments_around(trajectory)
    for index, event in enumerate(trajectory.events):
        more = explain_event(trajectory, index, around).note
        notes.append("; ".join(note for note in (event.note, more) if note))
    return tuple(notes)
