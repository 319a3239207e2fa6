"""A held-out run: measured, refitted and corrected, as a whole and a part of it enlarged."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..identification.diagnosis import Found
from ..identification.fitting.replay import Replay
from ..identification.recordings.recording import Recording
from .style import BLUE, GREY, INK, ORANGE, PALE, figure, styled

#: Most samples of the enlarged part, and the largest part of a run that still is an enlargement.
LONGEST, PART = 1500, 0.2
#: Fewer samples than this are dots, no course: of a run so short the whole says as much.
FEWEST = 50


@styled
def held_out(found: Found, recording: Recording | None = None) -> Figure | None:
    """The reported run in which the correction changes most: whole, with rests, and enlarged.

    The enlarged part lies around the largest change, and is marked in the whole run.
    """
    done, replays = found.diagnosis, found.split.report
    before = done.declared.predictor.predict(done.declared.values, replays)
    after = done.corrected.predictor.predict(done.corrected.values, replays)
    shown = _most_telling(replays, before, after)
    if shown is None:
        return None
    i, channel, centre = shown
    replay = replays[i]
    unit, written = units(recording, channel)
    seen = replay.observed[channel]
    # At rest a force may be anything: where it is not compared it is not drawn either.
    told = [
        series if replay.told else np.where(seen.keep, series, np.nan)
        for series in (before[channel][i], after[channel][i])
    ]
    lines = [
        (seen.values, GREY, 3.2, "measured"),
        (told[0], ORANGE, 1.1, "refitted"),
        (told[1], BLUE, 1.1, "corrected"),
    ]
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
        if "speed" in after:
            rests(ax, replay.time[span], after["speed"][i][span])
        ax.set_ylabel(f"{channel.replace('_', ' ')} [{unit}]")
        ax.set_title(name, loc="right", fontsize="small")
        ax.margins(x=0.01)
    picture.axes[0].legend(ncols=4, loc="lower left", bbox_to_anchor=(0.0, 1.0))
    if part is not None:
        ends = replay.time[part]
        picture.axes[0].axvspan(ends[0], ends[-1], color=PALE, lw=0, zorder=0)
    picture.axes[-1].set_xlabel("time [s]")
    return picture


def enlarged(samples: int, centre: int) -> slice | None:
    """The part of a run around a sample that is drawn once more; None of a short run."""
    size = min(LONGEST, int(PART * samples))
    if size < FEWEST:
        return None
    first = min(max(0, centre - size // 2), samples - size)
    return slice(first, first + size)


def _most_telling(
    replays: Sequence[Replay], before: Mapping[str, Sequence], after: Mapping[str, Sequence]
) -> tuple[int, str, int] | None:
    """Run, channel and sample of the largest change, in deviations of the noise.

    Where nothing was found to correct, of the largest error.
    """

    def largest(other: Callable[[int, str], np.ndarray]) -> tuple[float, int, str, int]:
        each = []
        for i, replay in enumerate(replays):
            for channel, seen in replay.observed.items():
                apart = np.abs(np.nan_to_num(after[channel][i] - other(i, channel))) / seen.sd
                k = int(np.argmax(apart))
                each.append((float(apart[k]), i, channel, k))
        return max(each, default=(0.0, -1, "", 0))

    found = largest(lambda i, channel: before[channel][i])
    if found[0] == 0.0:
        found = largest(lambda i, channel: replays[i].observed[channel].values)
    return None if found[1] < 0 else found[1:]


def rests(ax: Axes, time: np.ndarray, speed: np.ndarray) -> None:
    """A stripe below the curves where the corrected model sticks (its speed is exactly 0)."""
    if (speed == 0.0).any():
        across = ax.get_xaxis_transform()
        ax.fill_between(time, 0.0, 0.04, where=speed == 0.0, color=INK, lw=0, transform=across,
                        label="stuck (corrected model)")  # fmt: skip


def units(recording: Recording | None, channel: str) -> tuple[str, Callable]:
    """Unit of a channel in its recording and what turns SI values into it."""
    if recording is None or channel not in recording.channels:
        return "SI", lambda values: values
    c = recording.channels[channel]
    return c.unit, lambda values: (c.sign * values - c.shift) / c.scale
