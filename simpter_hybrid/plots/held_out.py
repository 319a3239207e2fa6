"""A held-out run: measured, refitted and corrected, as a whole and a part of it enlarged."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from ..identification.held_out_predictions import HeldOutPredictions
from ..identification.recordings.recording import Recording
from .recorded_units import units
from .sticking import sticking, stripes
from .style import BLUE, GREEN, GREY, ORANGE, PALE, figure, styled

#: Most samples of the enlarged part, and the largest part of a run that still is an enlargement.
LONGEST, PART = 1500, 0.2
#: Fewer samples than this are dots, no course: of a run so short the whole says as much.
FEWEST = 50


@styled
def held_out(told: HeldOutPredictions, recording: Recording | None = None) -> Figure | None:
    """The reported run whose error the correction lowers most: whole, with rests, and enlarged.

    The enlarged part lies around the largest change, and is marked in the whole run.
    """
    if told.telling is None:
        return None
    i, channel, centre = told.telling.run, told.telling.channel, told.telling.sample
    replay = told.replays[i]
    unit, written = units(recording, channel)
    seen = replay.observed[channel]

    def drawn(series: np.ndarray) -> np.ndarray:
        """At rest a force may be anything: where it is not compared it is not drawn either."""
        return series if replay.drive_is_exact else np.where(seen.keep, series, np.nan)

    lines = [(seen.values, GREY, 3.2, "measured")]
    if told.declared is not None:
        lines.append((drawn(told.declared[channel][i]), GREEN, 1.1, "declared"))
    lines.append((drawn(told.before[channel][i]), ORANGE, 1.1, "refitted"))
    if told.changed:
        lines.append((drawn(told.after[channel][i]), BLUE, 1.1, "corrected"))
    stuck = sticking(told.corrected.predictor, told.corrected.values, replay)
    parts = [(slice(0, replay.time.size), "whole run")]
    part = enlarged(replay.time.size, centre)
    if part is not None:
        parts.append((part, "enlarged"))
    picture = figure(
        0.6 + 2.0 * len(parts), f"{replay.name}, held out: {channel.replace('_', ' ')}"
    )
    for row, (span, name) in enumerate(parts):
        ax = picture.add_subplot(len(parts), 1, row + 1)
        for values, colour, width, label in lines:
            ax.plot(replay.time[span], written(values[span]), color=colour, lw=width, label=label)
        # Refitted and corrected are one model where nothing was found.
        of = f"stuck ({lines[-1][3]} model)"
        stripes(ax, replay.time[span], {name: w[span] for name, w in stuck.items()}, of)
        ax.set_ylabel(f"{channel.replace('_', ' ')} [{unit}]")
        ax.set_title(name, loc="right", fontsize="small")
        ax.margins(x=0.01)
    picture.axes[0].legend(ncols=4, loc="lower left", bbox_to_anchor=(0.0, 1.0))
    if part is not None:
        ends = replay.time[part]
        picture.axes[0].axvspan(ends[0], ends[-1], color=PALE, lw=0, zorder=0)
    apart = " (the error is told without a straight line of each window)" if seen.lines else ""
    picture.axes[-1].set_xlabel(f"time [s]{apart}")
    return picture


def enlarged(samples: int, centre: int) -> slice | None:
    """The part of a run around a sample that is drawn once more; None of a short run."""
    size = min(LONGEST, int(PART * samples))
    if size < FEWEST:
        return None
    first = min(max(0, centre - size // 2), samples - size)
    return slice(first, first + size)
