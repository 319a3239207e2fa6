"""One look for all pictures: colours that the colour-blind and a grey print can tell apart."""

from __future__ import annotations

import functools
import io
from collections.abc import Callable
from typing import Any

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.text import Text

from ..kernel.records import BACKWARD, FORWARD, FREE, STICK
from ..trajectory import Trajectory

# Okabe and Ito's palette (Color Universal Design, 2008).
BLUE, ORANGE, GREEN, PINK = "#0072B2", "#E69F00", "#009E73", "#CC79A7"
SKY, VERMILION = "#56B4E9", "#D55E00"
INK, GREY, PALE = "#222222", "#8A8A8A", "#E4E4E4"

#: One colour and one line style a clutch, repeated when there are more than eight.
CLUTCH_COLOURS = (BLUE, ORANGE, GREEN, PINK, SKY, VERMILION, INK, GREY)
MODE_COLOURS = {FORWARD: SKY, BACKWARD: VERMILION, STICK: INK, FREE: PALE}
MODE_HATCHES = {FORWARD: "", BACKWARD: "//////", STICK: "", FREE: ""}
MODE_LABELS = {FORWARD: "slips forward", BACKWARD: "slips backward", STICK: "stuck", FREE: "off"}

#: How events are drawn: colour, line style, marker.
EVENT_STYLES: dict[str, tuple[str, Any, str]] = {
    "breakaway": (VERMILION, (0, (4, 2)), "^"),
    "slip stop": (INK, "-", "v"),
    "other": (GREY, ":", "|"),
}

RC = {
    "font.size": 10,
    "axes.titlesize": 11,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.labelsize": 10,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.edgecolor": GREY,
    "axes.labelcolor": INK,
    "axes.axisbelow": True,
    "axes.grid": True,
    "grid.color": "#EEEEEE",
    "xtick.color": INK,
    "ytick.color": INK,
    "legend.frameon": False,
    "legend.fontsize": 9,
    "lines.linewidth": 1.6,
    "lines.solid_capstyle": "round",
    "hatch.linewidth": 0.8,
    "savefig.facecolor": "white",
    "svg.hashsalt": "simpter_hybrid",
}
WIDTH = 9.0


def styled(draw: Callable) -> Callable:
    """Draw with this look, whatever the user's settings."""

    @functools.wraps(draw)
    def inside(*arguments, **named):
        with matplotlib.rc_context():
            matplotlib.rcdefaults()
            matplotlib.rcParams.update(RC)
            return draw(*arguments, **named)

    return inside


def clutch_colour(i: int) -> str:
    """Colour of clutch ``i`` (from 0)."""
    return CLUTCH_COLOURS[i % len(CLUTCH_COLOURS)]


def figure(height: float, title: str) -> Figure:
    """A figure ``height`` inches high."""
    made = Figure(figsize=(WIDTH, height), layout="constrained")
    made.suptitle(title, x=0.01, ha="left", fontsize=13, fontweight="bold", color=INK)
    return made


def plain_log(axis: Any) -> None:
    """A logarithmic axis with ticks at 1, 2 and 5 of each decade, written without powers."""
    from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator

    axis.set_major_locator(LogLocator(10.0, subs=(1.0, 2.0, 5.0)))
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axis.set_minor_locator(NullLocator())


def legend_beside_title(made: Figure, handles: list[Any]) -> None:
    """One line of a legend above all axes, on the right, where it hides no data."""
    made.legend(
        handles, [h.get_label() for h in handles], loc="outside upper right", ncols=len(handles),
        fontsize=8, handletextpad=0.3, columnspacing=1.2,
    )  # fmt: skip


@styled
def png(picture: Figure, dpi: int = 120) -> bytes:
    """The picture as PNG; the same picture gives the same bytes."""
    # A "$" is one of a name, but in ticks.
    ticks = {t for ax in picture.axes for axis in (ax.xaxis, ax.yaxis) for t in axis.findobj(Text)}
    labels = {axis.label for ax in picture.axes for axis in (ax.xaxis, ax.yaxis)}
    for text in picture.findobj(Text):
        if "$" in text.get_text() and text not in ticks - labels:
            text.set_parse_math(False)
    buffer = io.BytesIO()
    picture.savefig(buffer, format="png", dpi=dpi, metadata={"Software": None})
    return buffer.getvalue()


def event_style(kind: str) -> tuple[str, Any, str]:
    """Colour, line style and marker of a kind of event."""
    return EVENT_STYLES.get(kind, EVENT_STYLES["other"])


def mark_events(ax: Axes, trajectory: Trajectory, clutch: int | None = None) -> None:
    """Thin vertical lines at the events: all of them, or those of one clutch (from 0)."""
    for event in trajectory.events:
        if event.kind == "start":
            continue  # on the axis, where nothing would be seen
        if clutch is None or clutch + 1 in event.clutches:
            colour, line, _ = event_style(event.kind)
            ax.axvline(event.t, color=colour, linestyle=line, linewidth=0.8, alpha=0.6, zorder=1)


def event_handles(trajectory: Trajectory) -> list[Line2D]:
    """Legend entries for the kinds of events that are marked."""
    marked = {e.kind for e in trajectory.events} - {"start"}
    kinds = {kind if kind in EVENT_STYLES else "other" for kind in marked}
    words = {"other": "other event", "breakaway": "breakaway", "slip stop": "stop of slip"}
    return [
        Line2D([], [], color=style[0], linestyle=style[1], linewidth=1.0, label=words[kind])
        for kind, style in EVENT_STYLES.items()
        if kind in kinds
    ]


def mode_handles(trajectory: Trajectory) -> list[Patch]:
    """Legend entries for the modes that occur."""
    found = set(np.unique(trajectory.mode).tolist())
    return [
        Patch(
            facecolor=MODE_COLOURS[code],
            hatch=MODE_HATCHES[code],
            edgecolor="white",
            label=MODE_LABELS[code],
        )
        for code in (FORWARD, STICK, BACKWARD, FREE)
        if code in found
    ]


def mode_spans(trajectory: Trajectory, clutch: int) -> list[tuple[float, float, int]]:
    """Longest intervals [s] of one mode of a clutch (from 0): first and last instant, mode."""
    spans: list[tuple[float, float, int]] = []
    for (start, end), code in zip(
        trajectory.segment_t.tolist(), trajectory.mode[:, clutch].tolist(), strict=True
    ):
        if end <= start:
            continue
        if spans and spans[-1][2] == code:
            spans[-1] = (spans[-1][0], end, code)
        else:
            spans.append((start, end, code))
    return spans


def ribbon(ax: Axes, trajectory: Trajectory, clutch: int) -> None:
    """A strip that shows a clutch's mode over time."""
    for start, end, code in mode_spans(trajectory, clutch):
        ax.axvspan(
            start,
            end,
            facecolor=MODE_COLOURS[code],
            hatch=MODE_HATCHES[code],
            edgecolor="white" if MODE_HATCHES[code] else MODE_COLOURS[code],
            linewidth=0.0,
        )
    ax.set_yticks([])
    ax.set_ylim(0.0, 1.0)
    ax.grid(False)
    for side in ax.spines.values():
        side.set_visible(False)
