"""Pictures of a diagnosis; drawn here: error ladder, ranking, dependence, empirical curve."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from ..identification.empirical_terms import goes_by
from ..identification.held_out_gains import HeldOutGain
from ..identification.held_out_predictions import HeldOutPredictions
from ..identification.recordings.recording import Recording
from ..identification.reporting.tables import STAGES
from ..identification.result import Diagnosis
from ..identification.tracing.further import by_chance
from ..identification.tracing.locating import located, without_coordinate
from ..identification.tracing.ringing import RINGING
from ..identification.tracing.rivals import LEAST_GAIN
from ..identification.tracing.round import Round
from ..identification.tracing.signature import Dependence
from ..identification.tracing.slow_state import RUN
from ..identification.tracing.traced import of_all_balances
from .added import added
from .coordinate_units import coordinate_label, force_unit
from .held_out import held_out
from .residual import residual
from .style import (
    BLUE,
    GREEN,
    GREY,
    INK,
    ORANGE,
    SKY,
    VERMILION,
    figure,
    legend_beside_title,
    png,
    styled,
)

COLOURS = {"declared": GREY, "refitted": ORANGE, "after": BLUE, "empirical": SKY, "floor": GREEN}
#: The two curves of a dependence.
WITHOUT, WITH = "without", "with the best"
#: No line goes across so large a part of a coordinate, if it is so many times a usual bin.
EMPTY, MANY = 0.2, 10.0
#: Errors that differ by more than this are drawn on a logarithmic scale.
WIDE = 30.0


def pictures(
    found: Diagnosis,
    told: HeldOutPredictions,
    recording: Recording | None = None,
    gains: Sequence[Sequence[HeldOutGain]] = (),
) -> dict[str, bytes]:
    """PNG files by name, the most telling first; `told` and `gains` are of the runs held out."""
    drawn = {"error_ladder": error_ladder(found), "dependence": dependence(found),
             "residual": residual(told, recording), "added": added(found), "curve": curve(found),
             "held_out": held_out(told, recording),
             "ranking": ranking(found, next(iter(gains), ()))}  # fmt: skip
    return {name: png(picture) for name, picture in drawn.items() if picture is not None}


@styled
def error_ladder(found: Diagnosis) -> Figure:
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
        own, base = found.errors[stage], found.errors[unit]
        # A channel that stays at one value in all runs held out has no floor.
        values = [own.get(c, np.nan) / base[c] if base[c] > 0.0 else np.nan for c in channels]
        place = np.arange(len(channels)) + (k - 0.5 * (len(shown) - 1)) * width
        bars = ax.bar(place, values, width, label=stage, color=COLOURS[stage])
        ax.bar_label(bars, [f"{v:.3g}" if np.isfinite(v) else "" for v in values], fontsize=7)
        shares += [v for v in values if v > 0.0]
    ax.set_xticks(np.arange(len(channels)), [c.replace("_", " ") for c in channels])
    ax.set_ylabel("rms error / floor of noise" if unit == "floor" else "rms error / declared")
    if shares and max(shares) > WIDE * min(shares):
        ax.set_yscale("log")
    ax.margins(y=0.25)
    ax.legend(ncols=len(shown))
    return picture


def strongest(done: Round, faint: bool = True) -> tuple[str, Dependence] | None:
    """The balance and dependence that say most of a residual: what counts before what does not.

    Of a channel if the effect that was found follows it.  `faint`: whether one that does not count
    is shown where none does.
    """
    if (followed := _followed(done)) is not None:
        return followed
    sure = [d for d in of_all_balances(done.before) if d.p_value <= 0.01]
    counts = located(sure) or without_coordinate(sure)
    places = [d for d in sure if not d.coordinate.startswith(RINGING)] if faint else []
    first = next((d for d in sure if d.coordinate in counts), next(iter(places), None))
    if first is None:
        return None
    balance, _, name = first.coordinate.rpartition(":")
    return balance, replace(first, coordinate=name)


def _followed(done: Round) -> tuple[str, Dependence] | None:
    """Balance of a logged channel on which an accepted effect depends, and what that shows."""
    accepted = done.verdict.accepted
    own = accepted.candidate.coordinates if accepted is not None else ()
    told = [(b, d) for b, ds in done.logged.items() for d in ds if f"{b}:{d.coordinate}" in own]
    return max(told, key=lambda found: found[1].gain, default=None)


@styled
def dependence(found: Diagnosis) -> Figure | None:
    """The strongest dependence of the residual, without and with what was found.

    Two rounds a row: titles and names of coordinates need the width.  Of a diagnosis that misses
    nothing only what rings: any other curve would look like a lack.
    """
    every = enumerate(found.search.rounds, start=1)
    faint = found.empirical is None  # beside a curve that tells it a faint one misleads
    rounds = [(number, r, seen) for number, r in every if (seen := strongest(r, faint))]
    if found.search.verdict.kind == "nothing missing":
        rounds = [(number, r, seen) for number, r, seen in rounds if seen[0] == RINGING]
    if not rounds:
        return None
    columns = min(len(rounds), 2)
    rows = -(-len(rounds) // columns)
    picture = figure(0.4 + 2.8 * rows, "What the residual depends on")
    for k, (number, done, chosen) in enumerate(rounds):
        ax = picture.add_subplot(rows, columns, k + 1)
        if chosen[0] == RINGING:
            _spectrum(ax, chosen[1])
            ax.set_title(f"round {number}: rings after breakaway")
            continue
        if chosen[1].coordinate == RUN:
            _by_run(ax, *chosen, force_unit(found))
        else:
            _curves(ax, done, *chosen, force_unit(found))
        ax.set_title(f"round {number}: {100 * chosen[1].gain:.0f} % of the mean square")
    handles = {line.get_label(): line for ax in picture.axes for line in ax.lines}
    legend: list[Any] = [handles[n] for n in (WITHOUT, WITH) if n in handles]
    if any(ax.collections for ax in picture.axes):
        far = " (in part beyond the axes)" if any(map(_goes_beyond, picture.axes)) else ""
        legend.append(Patch(color=GREY, alpha=0.3, label=f"95 %, runs left out in turn{far}"))
    legend_beside_title(picture, legend)
    return picture


def _curves(ax: Axes, done: Round, balance: str, before: Dependence, unit: str) -> None:
    """One round's strongest dependence, and what is left of it with the best candidate."""
    after = next((d for d in done.after[balance] if d.coordinate == before.coordinate), None)
    for d, colour, label in ((before, VERMILION, WITHOUT), (after, BLUE, WITH)):
        if d is not None:
            for k, part in enumerate(stretches(d.centres)):
                name = label if k == 0 else None
                ax.plot(d.centres[part], d.curve[part], "o-", color=colour, ms=3, label=name)
    ax.axhline(0.0, color=GREY, lw=0.8)
    # A band of two or three runs is many times as high as its curve: the picture is the curve's.
    ax.set_ylim(ax.get_ylim())
    for d, colour in ((before, VERMILION), (after, BLUE)):
        if d is not None and d.band is not None and np.isfinite(d.band).all():
            low, high = d.curve - d.band, d.curve + d.band
            for part in stretches(d.centres):
                ends = (d.centres[part], low[part], high[part])
                ax.fill_between(*ends, color=colour, alpha=0.15, linewidth=0)
    along = before.coordinate
    ax.set_xlabel(coordinate_label(along, unit))
    # On two lines: panels are low, and a long name of a balance would leave them.
    where = f"at {before.at:.3g} {unit} passed on " if before.scaled.any() else ""
    ax.set_ylabel(f"{balance.replace('_', ' ')} residual\n{where}[{unit}]")


def _goes_beyond(ax: Axes) -> bool:
    """Whether a band is higher than what is drawn of it."""
    low, high = ax.get_ylim()
    ends = [np.asarray(path.vertices)[:, 1] for band in ax.collections for path in band.get_paths()]
    return any(end.min() < low or end.max() > high for end in ends)


def stretches(centres: np.ndarray) -> list[np.ndarray]:
    """Bins that lie beside one another; between stretches is nothing that a line could stand for.

    Of strokes at three speeds a line from one to the next drew a law that no row had told.
    """
    gaps = np.diff(centres)
    if not gaps.size:
        return [np.arange(centres.size)]
    wide = gaps > max(EMPTY * float(np.ptp(centres)), MANY * float(np.median(gaps)))
    return np.split(np.arange(centres.size), np.flatnonzero(wide) + 1)


def _by_run(ax: Axes, balance: str, before: Dependence, unit: str) -> None:
    """What neighbouring seconds tell of each second, run after run."""
    ends = np.flatnonzero(np.diff(np.floor(before.centres))) + 1
    for k, part in enumerate(np.split(np.arange(before.centres.size), ends)):
        label = WITHOUT if k == 0 else None
        ax.plot(before.centres[part], before.added[part], "o-", color=VERMILION, ms=3, label=label)
    ax.axhline(0.0, color=GREY, lw=0.8)
    ax.set_xlabel("run (and part of it)")
    ax.set_ylabel(f"{balance.replace('_', ' ')} residual\nby the seconds beside [{unit}]")


def _spectrum(ax: Axes, found: Dependence) -> None:
    """What stands out after breakaways, line by line."""
    ax.semilogy(found.centres, found.added, color=VERMILION, label=WITHOUT)
    ax.axhline(1.0, color=GREY, lw=0.8)
    ax.set_xlabel("frequency [Hz]")
    ax.set_ylabel("power after breakaways over\nthat elsewhere, by its median")


@styled
def ranking(found: Diagnosis, gains: Sequence[HeldOutGain] = ()) -> Figure | None:
    """Gain of every candidate of the first round on the selecting runs, and on those held out."""
    trials = found.search.rounds[0].trials[:14] if found.search.rounds else ()
    if not trials:
        return None
    picture = figure(0.6 + 0.24 * len(trials), "What each candidate takes off the error")
    ax = picture.add_subplot()
    names = [t.candidate.name for t in trials][::-1]
    base = found.search.rounds[0].base
    chance = {t.candidate.name for t in trials if by_chance(t, base)}
    selecting = [100 * t.gain for t in trials][::-1]
    taken = {e.name for e in found.search.corrected.effects}
    ax.barh(names, selecting, color=[BLUE if n in taken else GREY for n in names])
    ax.set_yticks(range(len(names)), [f"{n} (chance)" if n in chance else n for n in names])
    ax.axvline(100 * LEAST_GAIN, color=INK, lw=1.0, ls="--")
    ends = [(g.name, 100 * g.gain, 100 * np.array([[g.gain - g.low], [g.high - g.gain]])
             if g.has_interval else np.zeros((2, 1)))
            for g in gains if g.name in names]  # fmt: skip
    for name, gain, apart in ends:
        ax.errorbar(gain, name, xerr=apart, fmt="o", color=VERMILION, ms=4, capsize=3, lw=1.2)
    # Of what does nothing and spoils a quiet block the interval has no lower end to show, nor has a
    # form that did not come near what it contains.
    most = max(200 * LEAST_GAIN, *selecting)
    ax.set_xlim(-0.6 * most, 1.05 * max([most, *(gain + apart[1, 0] for _, gain, apart in ends)]))
    on_them = "; dots: runs held out, 95 %" if ends else ""
    ax.set_xlabel(f"fall of the error on the selecting runs [%] (dashed: least believed){on_them}")
    return picture


@styled
def curve(found: Diagnosis) -> Figure | None:
    """The empirical term with the band of its knots, where there is one."""
    term = found.empirical
    if term is None:
        return None
    name = term.trial.candidate.name.partition(" within ")[0]
    picture = figure(2.8, f"Empirical term: {name} (no law)")
    ax = picture.add_subplot()
    half = np.where(np.isfinite(term.half_width), term.half_width, np.nan)
    place, value = term.drawn()
    # Of a curve over a turn the band goes on to the first knot, as the curve does.
    ends = term.place[-1] + term.place[1] - term.place[0]
    half = np.interp(place, [*term.place, ends], [*half, half[0]])
    place, knots = term.recorded(place), term.recorded(term.place)
    low, high = value - half, value + half
    ax.fill_between(place, low, high, color=BLUE, alpha=0.2, linewidth=0, label="95 %")
    ax.plot(place, value, color=BLUE)
    ax.plot(knots, term.value, "o", color=BLUE, ms=4, label="fitted knots")
    ax.axhline(0.0, color=GREY, lw=0.8)
    along, unit = goes_by(term.coordinate).partition(":")[2], force_unit(found)
    ax.set_xlabel(coordinate_label(along, unit))
    ax.set_ylabel(_of_curve(term.trial.candidate.name, unit))
    ax.legend()
    return picture


def _of_curve(kind: str, unit: str) -> str:
    """What an empirical curve's ordinate is."""
    if kind.startswith("empirical-by"):
        return "relative change of friction"
    name = "force" if unit == "N" else "torque"
    return f"{name} over speed [SI]" if kind.startswith("empirical-drag") else f"{name} [{unit}]"
