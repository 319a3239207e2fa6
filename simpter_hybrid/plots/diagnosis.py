"""Pictures of a diagnosis: the error ladder, the ranking, the dependence, a held-out trace."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..identification.diagnosis import Found
from ..identification.recording import Recording
from ..identification.rounds import Round
from ..identification.signature import Dependence
from .style import BLUE, GREEN, GREY, INK, ORANGE, SKY, VERMILION, figure, png, styled

STAGES = ("declared", "refitted", "after", "empirical", "floor")
COLOURS = {"declared": GREY, "refitted": ORANGE, "after": BLUE, "empirical": SKY, "floor": GREEN}
#: Errors that differ by more than this are drawn on a logarithmic scale.
WIDE = 30.0


def pictures(found: Found, recording: Recording | None = None) -> dict[str, bytes]:
    """PNG files by name, the most telling first."""
    drawn = {"error_ladder": error_ladder(found), "dependence": dependence(found),
             "curve": curve(found), "ranking": ranking(found),
             "held_out": held_out(found, recording)}  # fmt: skip
    return {name: png(picture) for name, picture in drawn.items() if picture is not None}


@styled
def error_ladder(found: Found) -> Figure:
    """Error per channel, declared, refitted, after, over the floor of noise.

    Without replicates: over the declared model's error.
    """
    picture = figure(2.6, "Error on runs that had no part in finding it")
    ax = picture.add_subplot()
    channels = [c for c in found.errors["after"] if c in found.errors["floor"]]
    unit = "floor" if channels else "declared"
    shown = [s for s in STAGES if s in found.errors and (channels or s != "floor")]
    channels = channels or list(found.errors["after"])
    width = 0.8 / len(shown)
    shares: list[float] = []
    for k, stage in enumerate(shown):
        values = [found.errors[stage].get(c, np.nan) / found.errors[unit][c] for c in channels]
        place = np.arange(len(channels)) + (k - 0.5 * (len(shown) - 1)) * width
        bars = ax.bar(place, values, width, label=stage, color=COLOURS[stage])
        ax.bar_label(bars, [f"{v:.3g}" if np.isfinite(v) else "" for v in values], fontsize=7)
        shares += [v for v in values if v > 0.0]
    ax.set_xticks(np.arange(len(channels)), [c.replace("_", " ") for c in channels])
    ax.set_ylabel("times the floor of noise" if unit == "floor" else "times the declared model's")
    if shares and max(shares) > WIDE * min(shares):
        ax.set_yscale("log")
    ax.margins(y=0.25)
    ax.legend(ncols=len(shown))
    return picture


def strongest(done: Round) -> tuple[str, Dependence] | None:
    """The balance and coordinate of which the residual says most."""
    found = [(b, d) for b, v in done.before.items() for d in v if d.p_value <= 0.01]
    return max(found, key=lambda item: item[1].gain, default=None)


@styled
def dependence(found: Found) -> Figure | None:
    """The strongest dependence of the residual, without and with what was found."""
    rounds = [r for r in found.diagnosis.rounds if strongest(r)]
    if not rounds:
        return None
    picture = figure(3.0, "What the residual depends on")
    for k, done in enumerate(rounds):
        ax = picture.add_subplot(1, len(rounds), k + 1)
        chosen = strongest(done)
        assert chosen is not None  # rounds without one were left out above
        balance, before = chosen
        after = next((d for d in done.after[balance] if d.coordinate == before.coordinate), None)
        for d, colour, label in ((before, VERMILION, "without"), (after, BLUE, "with the best")):
            if d is not None:
                low, high = d.added - d.scaled, d.added + d.scaled
                ax.fill_between(d.centres, low, high, color=colour, alpha=0.15, linewidth=0)
                ax.plot(d.centres, d.added + d.scaled, "o-", color=colour, ms=3, label=label)
        ax.axhline(0.0, color=GREY, lw=0.8)
        ax.set_xlabel(before.coordinate.replace("_", " ") + " [SI]")
        unit = force_unit(found)
        ax.set_ylabel(f"{balance} residual at 1 {unit} [{unit}]")
        ax.set_title(f"round {k + 1}: {100 * before.gain:.0f} % of the square")
        ax.legend()
    return picture


def force_unit(found: Found) -> str:
    """Of residual forces: a rig whose coordinates are all lengths has forces, else torques."""
    declared = found.diagnosis.declared.predictor.declared  # type: ignore[attr-defined]
    kinds = declared.device.coordinate_dimensions
    return "N" if kinds and set(kinds) == {"length"} else "N m"


@styled
def ranking(found: Found) -> Figure | None:
    """Held-out gain of every candidate of the first round."""
    trials = found.diagnosis.rounds[0].trials[:14] if found.diagnosis.rounds else ()
    if not trials:
        return None
    picture = figure(0.6 + 0.24 * len(trials), "Fall of the held-out error with each candidate")
    ax = picture.add_subplot()
    names = [t.candidate.name for t in trials][::-1]
    gains = [100 * t.gain for t in trials][::-1]
    taken = {e.name for e in found.diagnosis.corrected.effects}
    ax.barh(names, gains, color=[BLUE if n in taken else GREY for n in names])
    ax.axvline(2.0, color=INK, lw=1.0, ls="--")
    ax.set_xlabel("% (dashed: least gain that is believed)")
    return picture


@styled
def curve(found: Found) -> Figure | None:
    """The empirical term with the band of its knots, where there is one."""
    term = found.empirical
    if term is None:
        return None
    picture = figure(2.8, f"Empirical term: {term.trial.candidate.name} (no law)")
    ax = picture.add_subplot()
    half = np.where(np.isfinite(term.half_width), term.half_width, np.nan)
    low, high = term.value - half, term.value + half
    ax.fill_between(term.place, low, high, color=BLUE, alpha=0.2, linewidth=0, label="95 %")
    ax.plot(term.place, term.value, "o-", color=BLUE, ms=4, label="fitted knots")
    ax.axhline(0.0, color=GREY, lw=0.8)
    ax.set_xlabel(term.coordinate.partition(":")[2].replace("_", " ") + " [SI]")
    friction = term.trial.candidate.name.startswith("empirical-by")
    ax.set_ylabel("relative change of friction" if friction else "force [SI]")
    ax.legend()
    return picture


@styled
def held_out(found: Found, recording: Recording | None = None) -> Figure | None:
    """The reported run in which the correction changes most: whole, with rests, and enlarged."""
    done, replays = found.diagnosis, found.split.report
    before = done.declared.predictor.predict(done.declared.values, replays)
    after = done.corrected.predictor.predict(done.corrected.values, replays)
    change = [
        (np.nanmax(np.abs(np.nan_to_num(before[c][i] - after[c][i])) / o.sd), i, c)
        for i, r in enumerate(replays)
        for c, o in r.observed.items()
    ]
    if not change:
        return None
    _, i, channel = max(change)
    replay = replays[i]
    centre = int(np.argmax(np.abs(np.nan_to_num(before[channel][i] - after[channel][i]))))
    unit, shown = units(recording, channel)
    lines = [
        (replay.observed[channel].values, GREY, 3.2, "measured"),
        (before[channel][i], ORANGE, 1.1, "refitted"),
        (after[channel][i], BLUE, 1.1, "corrected"),
    ]
    picture = figure(4.6, f"{replay.name}, held out: {channel.replace('_', ' ')}")
    parts = slice(0, replay.time.size), slice(max(0, centre - 750), centre + 750)
    for row, (part, name) in enumerate(zip(parts, ("whole run", "enlarged"), strict=True)):
        ax = picture.add_subplot(2, 1, row + 1)
        for values, colour, width, label in lines:
            ax.plot(replay.time[part], shown(values[part]), color=colour, lw=width, label=label)
        if "speed" in after:
            rests(ax, replay.time[part], after["speed"][i][part])
        ax.set_ylabel(f"{name} [{unit}]")
        ax.margins(x=0.01)
    picture.axes[0].legend(ncols=4, loc="lower left", bbox_to_anchor=(0.0, 1.0))
    picture.axes[1].set_xlabel("time [s]")
    return picture


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
