"""The run to make next: what is laid down in it against time."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure

from ..identification.reporting.next_runs import NextRun
from .style import BLUE, figure, png, styled

#: Most channels that are drawn.
CHANNELS = 4


def next_run_pictures(runs: Sequence[NextRun]) -> dict[str, bytes]:
    """PNG file of the first of these experiments that lays down a course; none if none does."""
    first = next((one for one in runs if one.runs), None)
    return {} if first is None else {"run_next": png(next_run(first))}


@styled
def next_run(asked: NextRun) -> Figure:
    """What changes in the first run of an experiment, a panel for each channel."""
    _, time, laid = asked.runs[0]
    changing = {name: x for name, x in laid.items() if np.ptp(x) > 0.0} or laid
    drawn = list(changing.items())[:CHANNELS]
    picture = figure(1.0 + 1.5 * len(drawn), f"Run next: {asked.experiment}")
    for row, (name, x) in enumerate(drawn):
        ax = picture.add_subplot(len(drawn), 1, row + 1)
        ax.plot(time - time[0], x, color=BLUE)
        ax.set_ylabel(name.replace("_", " ").replace(" [", "\n["))
        ax.margins(x=0.01)
    picture.axes[-1].set_xlabel("time [s]")
    return picture
