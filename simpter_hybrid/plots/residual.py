"""What both models leave of a held-out run, channel by channel, against time."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..identification.fitting.replay import Observation
from ..identification.fitting.residual import deviation
from ..identification.held_out_predictions import HeldOutPredictions, noise_of
from ..identification.recordings.recording import Recording
from .recorded_units import difference_units
from .style import BLUE, GREY, INK, ORANGE, figure, styled

#: Most channels that are drawn, and most points of a curve: each is the mean of a block.
CHANNELS, POINTS = 4, 400
#: Along a curve that loses so much of a residual nothing counts as evidence.
NOTHING = 0.999
#: What all but a hundredth of a residual stays below, times this, is the height of a panel: a spike
#: at a breakaway leaves of all else a line.
MOSTLY, SHOWN = 0.99, 2.0
NOISE = "±2 deviations of noise, with what it does to inputs and starts"


@styled
def residual(told: HeldOutPredictions, recording: Recording | None = None) -> Figure | None:
    """Measured minus predicted as it is compared, refitted and corrected, in units of the record.

    The run is that of the held-out picture.
    """
    if told.telling is None:
        return None
    i = told.telling.run
    replay = told.replays[i]
    first = [told.telling.channel]  # it tells most: never the one for which there is no room
    channels = sorted([*first, *[c for c in replay.observed if c not in first][: CHANNELS - 1]])
    models = [("refitted", told.before, ORANGE)]
    if told.changed:
        models.append(("corrected", told.after, BLUE))
    picture = figure(1.0 + 1.9 * len(channels), f"{replay.name}, held out: measured - predicted")
    for row, channel in enumerate(channels):
        ax, seen = picture.add_subplot(len(channels), 1, row + 1), replay.observed[channel]
        unit, written = difference_units(recording, channel)
        sd = noise_of(recording, channel, seen, replay.time) / np.sqrt(replay.replicates)
        own, band = (2.0 * np.abs(written(x)) for x in (sd, moved_by_noise(seen, sd)))
        middle, wide, _, _ = blocks(replay.time, band)
        ax.fill_between(middle, -wide, wide, color=GREY, alpha=0.2, lw=0, label=NOISE)
        # Where a model is far off the band is thinner than a line.
        size = f"noise of the sensor: ±{float(own):.2g} {unit}"
        ax.text(0.995, 0.03, size, transform=ax.transAxes, ha="right", fontsize="small", color=INK)
        reach = 0.0
        for label, predicted, colour in models:
            left = written(compared(seen, predicted[channel][i]))
            there = np.abs(left[np.isfinite(left)])
            reach = max(reach, float(np.quantile(there, MOSTLY)) if there.size else 0.0)
            _course(ax, replay.time, left, color=colour, label=label)
        ax.axhline(0.0, color=INK, lw=0.6)
        ax.set_ylabel(f"{channel.replace('_', ' ')} [{unit}]")
        if seen.windows and seen.lines:
            # The line is due to the start that is read off a noisy record.
            ax.set_title("less the line in each window", loc="right", fontsize="small")
        ax.margins(x=0.01)
        if reach > 0.0:  # a band that is far wider would leave of the curves a line
            ax.set_ylim(-SHOWN * reach, SHOWN * reach)
    picture.axes[-1].set_xlabel("time [s]  (means of blocks; pale: from least to largest in each)")
    handles, labels = picture.axes[0].get_legend_handles_labels()
    picture.legend(handles, labels, loc="outside lower center", ncols=len(handles), fontsize=8)
    return picture


def compared(seen: Observation, predicted: np.ndarray) -> np.ndarray:
    """Measured minus predicted [SI] (samples,), NaN where it is not compared."""
    whole = np.full(seen.values.size, np.nan)
    whole[seen.keep] = deviation(seen, predicted, weighed=False)
    return whole


def moved_by_noise(seen: Observation, sd: float) -> np.ndarray:
    """Deviation of what noise leaves [SI] (samples,): the sensor's and what that of inputs does.

    The latter goes along the curves of `rigs.input_noise`, whose sizes their weights tell; but for
    those of a start, along which nothing counts: what is drawn begins where it fits best.
    """
    square = np.ones(seen.values.size)
    ends = (*seen.windows[1:], square.size)
    for a, b, (shape, lost) in zip(seen.windows, ends, seen.curves, strict=False):
        noise = lost < NOTHING
        square[a:b] += shape[:, noise] ** 2 @ (1.0 / (1.0 - lost[noise]) ** 2 - 1.0)
    return sd * np.sqrt(square)


def blocks(time: np.ndarray, values: np.ndarray) -> tuple[np.ndarray, ...]:
    """Instants, means, least and largest values of at most `POINTS` blocks.

    NaN where a block holds no value.
    """
    size = -(-values.size // POINTS)
    starts = np.arange(0, values.size, size)
    there = np.isfinite(values)
    count = np.add.reduceat(there.astype(float), starts)
    total = np.add.reduceat(np.where(there, values, 0.0), starts)
    none = count == 0.0
    mean = np.where(none, np.nan, total / np.maximum(count, 1.0))
    least = np.minimum.reduceat(np.where(there, values, np.inf), starts)
    most = np.maximum.reduceat(np.where(there, values, -np.inf), starts)
    middle = time[np.minimum(starts + size // 2, time.size - 1)]
    return middle, mean, np.where(none, np.nan, least), np.where(none, np.nan, most)


def _course(ax: Axes, time: np.ndarray, values: np.ndarray, **style: Any) -> None:
    middle, mean, least, most = blocks(time, values)
    ax.fill_between(middle, least, most, color=style["color"], alpha=0.25, lw=0)
    ax.plot(middle, mean, lw=1.1, **style)
