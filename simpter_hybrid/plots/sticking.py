"""When the clutches of a model stick while it replays a run."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from ..identification.fitting.replay import Replay
from ..identification.rigs.free_start import started
from ..identification.rigs.simulated_runs import simulated_runs
from ..kernel.records import STICK
from ..machine_code.program import Cases, Program, Room
from .style import INK

#: A motion that is set from the record in more than one of so many samples is the record's own.
SET_OFTEN = 10
#: Room for a run of some seconds; one that needs more is repeated with more.
ROOM = Room(20_000, 40_000, 100_000)
#: Height of a clutch's stripe, and from one to the next, as parts of a panel's height.
STRIPE, APART = 0.035, 0.05


def sticking(predictor: Any, values: Mapping[str, float], replay: Replay) -> dict[str, np.ndarray]:
    """Clutch -> whether it sticks (samples,) in the model as it replays the run.

    `predictor`: a `ScenarioPredictor`.  Empty where the motion is set from the record at nearly
    every sample: there the model's modes say nothing, it never moves on its own.
    """
    (made,) = simulated_runs(started(predictor.simulated, values, [replay]), predictor.remembers)
    (_, given), ((_, first),) = predictor.played(values, made.run), made.parts
    rows = slice(first, first + replay.time.size)
    begins, ends = given.grid[rows][[0, -1]]
    if SET_OFTEN * sum(begins <= t <= ends for t, _ in given.restarts) > replay.time.size:
        return {}
    program, cases, restarts = predictor.runner.prepared(given)
    stuck = stuck_at(given.grid, *_segments(program, cases, restarts))[rows]
    names = predictor.runner.scenario.device.surfaces
    return {name: stuck[:, i] for i, name in enumerate(names)}


def _segments(
    program: Program, cases: Cases, restarts: tuple[np.ndarray, np.ndarray]
) -> tuple[np.ndarray, np.ndarray]:
    """First and last instants (segments, 2) and modes (segments, m) of one run."""
    room, found = ROOM, program.call(cases, ROOM, record=True, restarts=restarts)
    while found.done == 0:
        room = room.more()
        found = program.call(cases, room, record=True, restarts=restarts)
    count, m = found.kept(0, 1)[1], program.z["m"]
    spans = found.records["segment_t"][: 2 * count].reshape(count, 2)
    return spans, found.records["modes"][: m * count].reshape(count, m)


def stuck_at(time: np.ndarray, spans: np.ndarray, modes: np.ndarray) -> np.ndarray:
    """Whether each clutch sticks at each instant (samples, m).

    Parameters
    ----------
    time : ndarray (samples,)
        [s]
    spans : ndarray (segments, 2)
        First and last instant of every segment of the run [s].
    modes : ndarray of int (segments, m)
    """
    if not len(spans):
        return np.zeros((time.size, modes.shape[1]), bool)
    # At an event the side before it, as the rows of a run have it.
    segment = np.clip(np.searchsorted(spans[:, 0], time, side="left") - 1, 0, len(spans) - 1)
    return (modes[segment] == STICK) & (time <= spans[-1, 1])[:, None]


def stripes(ax: Axes, time: np.ndarray, stuck: Mapping[str, np.ndarray], label: str) -> None:
    """Below the curves one stripe a clutch where it sticks, named at its end if there are more."""
    shown = [name for name, where in stuck.items() if where.any() or len(stuck) > 1]
    low, high = ax.get_ylim()
    ax.set_ylim(low - APART * len(shown) * (high - low), high)
    across = ax.get_xaxis_transform()
    for row, name in enumerate(reversed(shown)):
        bottom = row * APART
        ax.fill_between(time, bottom, bottom + STRIPE, where=stuck[name], color=INK, lw=0,
                        transform=across, label=label)  # fmt: skip
        label = ""
        if len(stuck) > 1:
            ax.text(1.003, bottom, name, fontsize=6, transform=ax.transAxes, va="bottom")
