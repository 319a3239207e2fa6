"""Pictures of a diagnosis: the error ladder, the ranking, the dependence, a held-out trace."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from ..identification.diagnosis import Found
from ..identification.rounds import Round
from ..identification.signature import Dependence
from .style import BLUE, GREEN, GREY, INK, ORANGE, VERMILION, figure, png, styled

STAGES = ("declared", "refitted", "after", "floor")
COLOURS = {"declared": GREY, "refitted": ORANGE, "after": BLUE, "floor": GREEN}


def pictures(found: Found) -> dict[str, bytes]:
    """PNG files by name, the most telling first."""
    drawn = {"error_ladder": error_ladder(found), "dependence": dependence(found),
             "ranking": ranking(found), "held_out": held_out(found)}  # fmt: skip
    return {name: png(picture) for name, picture in drawn.items() if picture is not None}


@styled
def error_ladder(found: Found) -> Figure:
    """Error per channel, declared, refitted, after, over the replicate floor.

    Without replicates: over the declared model's error.
    """
    picture = figure(2.6, "Error on runs that had no part in finding it")
    ax = picture.add_subplot()
    channels = [c for c in found.errors["after"] if c in found.errors["floor"]]
    unit, shown = ("floor", STAGES) if channels else ("declared", STAGES[:-1])
    channels = channels or list(found.errors["after"])
    width = 0.8 / len(shown)
    for k, stage in enumerate(shown):
        values = [found.errors[stage].get(c, np.nan) / found.errors[unit][c] for c in channels]
        place = np.arange(len(channels)) + (k - 0.5 * (len(shown) - 1)) * width
        ax.bar(place, values, width, label=stage, color=COLOURS[stage])
    ax.set_xticks(np.arange(len(channels)), [c.replace("_", " ") for c in channels])
    ax.set_ylabel("times the replicate floor" if unit == "floor" else "times the declared model's")
    ax.margins(y=0.25)
    ax.legend(ncols=4)
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
        ax.set_ylabel(f"{balance} residual at 1 N m [N m]")
        ax.set_title(f"round {k + 1}: {100 * before.gain:.0f} % of the square")
        ax.legend()
    return picture


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
def held_out(found: Found) -> Figure | None:
    """The reported run in which the correction changes most, around where it does."""
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
    replay, seen = replays[i], replays[i].observed[channel]
    centre = int(np.argmax(np.abs(np.nan_to_num(before[channel][i] - after[channel][i]))))
    here = slice(max(0, centre - 750), centre + 750)
    picture = figure(2.8, f"{replay.name}, held out: {channel.replace('_', ' ')}")
    ax = picture.add_subplot()
    t = replay.time[here]
    ax.plot(t, seen.values[here], color=GREY, lw=0.7, label="measured")
    ax.plot(t, before[channel][i][here], color=ORANGE, label="refitted")
    ax.plot(t, after[channel][i][here], color=BLUE, label="corrected")
    ax.set_xlabel("time [s]")
    ax.set_ylabel("[SI]")
    ax.legend(ncols=3)
    return picture
