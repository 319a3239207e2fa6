"""One run of those that select, or fit, that holds what their error is above a right form's.

A clutch that let go an instant earlier in one run, or a knock: that is no form's, and a reader
looks at the run itself.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from ..fitting.replay import Replay
from ..fitting.residual import compared_only_where_predicted as of_told
from ..fitting.residual import places, residual_parts, rms
from ..result import Diagnosis

#: Of fewer runs one is no exception.
LEAST_RUNS = 5
#: One holds what is left if it has this part of what all have above the floor, and leaves so many
#: times what each of the others does: of two runs one may well have a bit more.
HOLDS, FAR = 0.9, 3.0
#: Of fewer fitted runs none is; it leaves so many times what is noise.
FEWEST, ALONE = 3, 1.5
#: Each of the others is within so many times what is noise: a run scatters by itself.
SCATTER = 1.1
#: By this channel a run slips or rests: it slips from so many deviations of the noise on.
SPEED, SLIPS = "speed", 6.0
#: Two of them do otherwise if they do so for this part of a stretch.
OTHERWISE = 0.1
#: Where in the run: between these parts of what it has above the floor.
MOST_OF_IT = 0.1, 0.9


class _Run(NamedTuple):
    """A run, the weighed residuals of it that a model leaves, and their rows."""

    replay: Replay
    residuals: np.ndarray
    rows: np.ndarray

    @property
    def error(self) -> float:
        return rms(self.residuals)


def one_run_sentence(found: Diagnosis) -> str:
    """Sentence on one run without which the others are at the floor; "" if there is none.

    Others like it must show nothing of the kind: what one kind of run alone shows is a lack.
    """
    done, limits = found.search, found.limits
    limit = limits.form if done.corrected.effects else limits.lack
    if done.verdict.kind == "nothing missing" or done.corrected.select_error <= limit * done.floor:
        return ""
    most = limit * done.floor
    runs = _runs(found, found.split.select)
    worst, others = _alone(runs, most, 1.0) if len(runs) >= LEAST_RUNS else (None, [])
    if worst is None:
        return ""
    kind = worst.replay.experiment
    like = [run for run in others if run.replay.experiment == kind]
    like += _runs(found, [r for r in found.fitted if r.experiment == kind])
    rest = rms(np.concatenate([run.residuals for run in others]))
    if rest > most or not like or max(r.error for r in like) > SCATTER * most:
        return ""
    begin, end = _stretch(worst, done.floor)
    return (
        f"Of the runs that select one alone leaves more than noise: {worst.replay.name} "
        f"({worst.error / done.floor:.2f} times the floor, most of it from {begin:.4g} to "
        f"{end:.4g} s; the others {rest / done.floor:.2f}). Look at what happened in it: a slip or "
        "a knock that does not come in other runs like it is no effect, and says nothing of its "
        "form."
    )


def ruling_selecting_sentence(found: Diagnosis) -> str:
    """Sentence on one selecting run, of two or more, that holds what they leave; "" if none does.

    Whether it is an exception nobody knows: a choice between candidates goes by that run.
    """
    done, limits = found.search, found.limits
    limit = limits.form if done.corrected.effects else limits.lack
    if done.verdict.kind == "nothing missing" or done.corrected.select_error <= limit * done.floor:
        return ""
    runs = sorted(_runs(found, found.split.select), key=lambda run: -run.error)
    above = [run.residuals.size * max(0.0, run.error**2 - done.floor**2) for run in runs]
    if len(runs) < 2 or above[0] < HOLDS * sum(above) or runs[0].error < FAR * runs[1].error:
        return ""
    rest = rms(np.concatenate([run.residuals for run in runs[1:]]))
    return (
        f"Of the {len(runs)} runs that select one holds {100 * above[0] / sum(above):.0f} % of "
        f"what is above noise: {runs[0].replay.name} ({runs[0].error / done.floor:.3g} times the "
        f"floor; the others {rest / done.floor:.3g}). What is said of candidates goes by "
        "that run: does it show what the others do, and has its sensor the noise there that is "
        "taken (`noise` in the map)? Let more runs like it, and unlike it, select."
    )


def one_fitted_run_sentence(found: Diagnosis) -> str:
    """Sentence on one fitted run without which all others are at the floor; "" if there is none.

    Of so few a hand that braked in one is most of what is missing: a search finds nothing then.
    """
    done, limits, floors = found.search, found.limits, found.floors
    most = (limits.form if done.corrected.effects else limits.lack) * floors.fit
    selecting = done.corrected.select_error / done.floor
    runs = _runs(found, found.fitted)
    worst, others = _alone(runs, most, ALONE) if len(runs) >= FEWEST else (None, [])
    if done.verdict.kind == "nothing missing" or worst is None:
        return ""
    if selecting > SCATTER * most / floors.fit:  # these show it as well
        return ""
    begin, end = _stretch(worst, floors.fit)
    rest = rms(np.concatenate([run.residuals for run in others]))
    why = _slips_in_one(found, worst, others, (begin, end)) or (
        "Did something else act in it (a hand, a stop)? If not, let a run like it select."
    )
    return (
        f"Of the fitted runs one alone leaves more than noise: {worst.replay.name} "
        f"({worst.error / floors.fit:.2f} times the floor, most of it from {begin:.4g} to "
        f"{end:.4g} s; the others {rest / floors.fit:.2f}). {why}"
    )


def _slips_in_one(
    found: Diagnosis, worst: _Run, others: Sequence[_Run], stretch: tuple[float, float]
) -> str:
    """Sentence that a run and one like it rest and slip alike then, as a model does not; else "".

    What drives them was measured: so near breakaway its noise decides what the model does.
    """
    model = found.search.corrected
    begin, end = (t - worst.replay.time[0] for t in stretch)

    def moves(replay: Replay, speed: np.ndarray) -> np.ndarray:
        since = replay.time - replay.time[0]
        return np.abs(speed[(since >= begin) & (since <= end)]) > SLIPS * replay.observed[SPEED].sd

    def both(replay: Replay) -> tuple[np.ndarray, np.ndarray]:
        predicted = model.predictor.predict(model.values, [replay])[SPEED][0]
        return moves(replay, replay.observed[SPEED].values), moves(replay, predicted)

    like = [r.replay for r in others if r.replay.experiment == worst.replay.experiment]
    for other in like if all(SPEED in r.observed for r in (worst.replay, *like)) else ():
        (seen, told), (seen_there, told_there) = both(worst.replay), both(other)
        if seen.size != seen_there.size:
            continue
        if np.mean(seen != seen_there) < OTHERWISE <= np.mean(told != told_there):
            return (
                f"It rests and slips then as {other.name} does, a run of the same kind, and the "
                "model slips in one of the two alone: so near breakaway a bit of torque decides "
                "that, rather than a hand or a stop."
            )
    return ""


def holding_sentence(found: Diagnosis) -> str:
    """The first of these that has something to say; "" if none does."""
    said = (one_run_sentence, one_fitted_run_sentence, ruling_selecting_sentence)
    return next((text for tell in said if (text := tell(found))), "")


def alone_when(found: Diagnosis) -> str:
    """The one selecting run that leaves more than noise, and from when to when; "" if none does."""
    runs = _runs(found, found.split.select)
    worst, _ = _alone(runs, found.limits.lack * found.search.floor, SCATTER)
    if worst is None:
        return ""
    begin, end = _stretch(worst, found.search.floor)
    return f"{worst.replay.name}, most of it from {begin:.4g} to {end:.4g} s"


def _alone(runs: Sequence[_Run], most: float, times: float) -> tuple[_Run | None, list[_Run]]:
    """The one run that leaves so many times what is noise, and the others, if these do not."""
    if len(runs) < 2:
        return None, []
    worst, *others = sorted(runs, key=lambda run: -run.error)
    alone = worst.error > times * most and others[0].error <= SCATTER * most
    return (worst, others) if alone else (None, [])


def _runs(found: Diagnosis, replays: Sequence[Replay]) -> list[_Run]:
    """What the corrected model leaves of each run."""
    if not replays:
        return []
    model = found.search.corrected
    predicted = model.predictor.predict(model.values, replays)
    compared = of_told(predicted, replays)
    residuals = np.concatenate([part for *_, part in residual_parts(predicted, compared)])
    run, row = places(compared).T
    made = [_Run(r, residuals[run == i], row[run == i]) for i, r in enumerate(compared)]
    return [run for run in made if run.residuals.size]


def _stretch(run: _Run, floor: float) -> tuple[float, float]:
    """From when to when what a run has above the floor came [s]."""
    order = np.argsort(run.rows, kind="stable")
    above = np.cumsum(run.residuals[order] ** 2 - floor**2)
    low, high = (part * above[-1] for part in MOST_OF_IT)
    begin = int(np.flatnonzero(above <= low)[-1]) if (above <= low).any() else 0
    end = max(begin, int(np.argmax(above >= high)))
    time = run.replay.time[run.rows[order]]
    return float(time[begin]), float(time[end])
