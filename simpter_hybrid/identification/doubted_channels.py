"""A sign or a unit that a map has wrong: recorded channels times a factor, one at a time."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

from .channel_factors import (
    Factors,
    exchanges,
    factors_of_quantity,
    judged_like,
    logged,
    quantities,
    with_factors,
)
from .fitting.replay import Replay
from .fitting.residual import rms, weighted_residuals
from .map_changes import Exchanged, MapChange, Times, unit_instead
from .numbers_instead import NumberInstead, numbers_instead
from .recordings.recording import Recording
from .rigs.bench import Bench
from .tracing.limits import IMPERFECT
from .tracing.rivals import FAR_WORSE

#: A channel is doubted where a factor leaves less than this part of the error: no sensor or force
#: that is recorded rightly could be turned round, or be ten times as large, and be explained twice
#: as well.  So nothing is asked where the error is less than twice the floor.
HALF = 0.5
#: A factor counts only if it leaves less than this part of what a drive of zero leaves.
LESS = 0.9
#: Runs that are asked together, one for each of two cores.
AT_ONCE = 2
#: Two joints' columns are doubted where they leave less than this exchanged: a model of them that
#: is far off may err less with either's for the other.
EXCHANGED = 0.25
#: A factor that another unit makes is asked about in place of one that leaves so many times less.
BY_A_UNIT = 2.0
#: A factor so small that a channel does nothing.
NOTHING = 1e-6


class Doubt(NamedTuple):
    """A change of a recording with which the model errs less: the map may be wrong there.

    Parameters
    ----------
    change : MapChange
    left : float
        Part of the error that is left with the change.
    part : str
        Which runs ask: those that ``select`` or those that ``fit``.
    numbers : tuple of NumberInstead
        Declared numbers that do about as much, one at a time, the best first.
    """

    change: MapChange
    left: float
    part: str = "select"
    numbers: tuple[NumberInstead, ...] = ()

    @property
    def changed(self) -> str:
        """The channels and what is done to them, in words."""
        return f"{' and '.join(self.change.channels)} {self.change.done}"


def doubted_channels(
    bench: Bench,
    recording: Recording,
    values: Mapping[str, float],
    replays: Sequence[Replay],
    error: float,
    floor: float,
    part: str = "select",
) -> tuple[Doubt, ...]:
    """What a wrong sign or unit of one quantity would explain, the best first.

    A factor has to leave less than half of what the model as declared leaves without it, too: a
    refit to other runs may be the worse. A model that errs far off may do better the less a channel
    does. So a factor counts only if it also leaves less than half of what is left where the channel
    does nothing, or with it the model as declared is at the floor and without the channel it is
    not; and several channels are named together only if they leave less than half of what some of
    them leave. Nor is a channel named where another leaves less than half of what it does.

    Parameters
    ----------
    bench : Bench
    recording : Recording
    values : mapping of str to float
        As declared: a refit to a wrong channel is itself far off.
    replays : sequence of Replay
        The runs asked, as they were judged: what is compared, and in which deviations.
    error, floor : float
        What the refitted model leaves of them, and what a perfect one would.
    part : str
        Which runs they are: ``select`` or ``fit``.
    """
    if HALF * error <= floor:
        return ()
    predictor: Any = bench.predictor
    as_read = rms(weighted_residuals(predictor, values, replays))
    most = HALF * min(1.0, as_read / error)
    hopeless = _hopeless(bench, part, recording, values, replays, most * error)

    def left(factors: Factors) -> float:
        return _left_times(bench, part, recording, values, replays, factors) / error

    def asked(names: Sequence[str], factor: float) -> float:
        factors = dict.fromkeys(names, factor)
        return 1.0 if hopeless(factors) else left(factors)

    # A motion or a force that is predicted is not moved at all where it is huge.
    compared = {name for replay in replays for name in replay.observed}
    motion = {n for n in recording.channels if n.startswith(("position", "speed"))}
    moved = {n for n in compared | motion if recording.channels[n].role == "measured"}
    found: list[Doubt] = []
    for names in quantities(recording):
        tried = {f: asked(names, f) for f in factors_of_quantity(recording, names)}
        factor = _likeliest(tried)
        if not tried or tried[factor] >= most:
            continue
        # No factor counts beyond `most`; half of what an idle channel leaves may be less than that.
        idle = left({n: 1.0 / NOTHING if n in moved else NOTHING for n in names})
        parts = [doubt.left for doubt in found if set(doubt.change.channels) < set(names)]
        right = tried[factor] * error <= IMPERFECT * floor and IMPERFECT * tried[factor] < idle
        if tried[factor] < HALF * min([idle, *parts]) or (right and not parts):
            found.append(Doubt(Times(logged(recording, names), factor), tried[factor], part))
    for exchanged in map(Exchanged, exchanges(recording)):
        changed = bench.made(exchanged.made(recording), part)
        error_so = _left_of(bench, values, replays, changed, {}) / error
        if error_so < min(most, EXCHANGED):
            found.append(Doubt(exchanged, error_so, part))
    least = min((doubt.left for doubt in found), default=0.0)
    near = [doubt for doubt in found if HALF * doubt.left <= least]
    return tuple(sorted(near, key=lambda doubt: doubt.left))


def _likeliest(tried: Mapping[float, float]) -> float:
    """The factor that leaves least, or one that a unit makes and that leaves hardly more.

    Of a pendulum in degrees for radians, with a zero that was a degree off, a hundredth left 1.7
    times less than what was right.
    """
    least = min(tried.values(), default=0.0)
    near = {f: left for f, left in tried.items() if left <= BY_A_UNIT * least}
    units = {f: left for f, left in near.items() if unit_instead(f)}
    return min(units or near, key=(units or near).__getitem__, default=1.0)


def least_wrong(
    bench: Bench,
    recording: Recording,
    values: Mapping[str, float],
    replays: Sequence[Replay],
    error: float,
    role: str = "input",
) -> Doubt | None:
    """The factor on a driving channel that leaves the least error, however much that is.

    None if every factor leaves more than the record as it is, or more than a drive of zero does.
    With ``measured`` as `role` of a channel of what moves, whatever an idle one leaves: a model
    that runs away is nearest to what moves most.
    """

    def left(names: Sequence[str], factor: float) -> float:
        factors = dict.fromkeys(names, factor)
        return _left_times(bench, "select", recording, values, replays, factors) / error

    found = []
    for names in quantities(recording):
        if all(recording.channels[n].role == role for n in names):
            least = min(1.0, LESS * left(names, NOTHING)) if role == "input" else 1.0
            tried = {f: left(names, f) for f in factors_of_quantity(recording, names)}
            found += [Doubt(Times(names, f), so) for f, so in tried.items() if so < least]
    return min(found, key=lambda doubt: doubt.left, default=None)


def with_numbers(
    doubts: Sequence[Doubt],
    predictor: Any,
    fitted: Mapping[str, float],
    runs: Sequence[Replay],
    asked: Mapping[str, Sequence[Replay]],
) -> tuple[Doubt, ...]:
    """Doubts of units, each with the declared numbers that do about as much by themselves.

    Parameters
    ----------
    doubts : sequence of Doubt
    predictor : ScenarioPredictor
        The declared model.
    fitted : mapping of str to float
        As refitted within its tolerances.
    runs : sequence of Replay
        By which a number is fitted.
    asked : mapping of str to sequence of Replay
        The runs that doubts are of, by their part.
    """
    most = {
        d: min(HALF, FAR_WORSE * d.left)
        for d in doubts
        if d.change.kind == "unit" and not d.numbers
    }
    # What a number leaves is the same whatever unit is doubted.
    found = {
        part: numbers_instead(
            predictor, fitted, runs, asked[part], max(m for d, m in most.items() if d.part == part)
        )
        for part in {d.part for d in most}
    }

    def near(doubt: Doubt) -> Doubt:
        numbers = tuple(n for n in found[doubt.part] if n.left <= most[doubt])
        return doubt._replace(numbers=numbers)

    return tuple(near(doubt) if doubt in most else doubt for doubt in doubts)


def _left_times(
    bench: Bench,
    part: str,
    recording: Recording,
    values: Mapping[str, float],
    replays: Sequence[Replay],
    factors: Factors,
) -> float:
    """Error of runs with channels times their factors, judged as they were."""
    changed = bench.made(with_factors(recording, factors), part)
    return _left_of(bench, values, replays, changed, factors)


def _left_of(
    bench: Bench, values: Mapping[str, float], replays: Sequence[Replay],
    changed: Sequence[Replay], factors: Factors,
) -> float:  # fmt: skip
    """Error of runs as changed, judged as they were."""
    again = [judged_like(a, b, factors) for a, b in zip(replays, changed, strict=True)]
    predictor: Any = bench.predictor
    return rms(weighted_residuals(predictor, values, again))


def _hopeless(
    bench: Bench, part: str, recording: Recording, values: Mapping[str, float],
    replays: Sequence[Replay], least: float,
) -> Callable[[Factors], bool]:  # fmt: skip
    """Whether some runs alone leave more than all may, if all are to leave less than `least`.

    Most factors are so wrong that the first runs tell.
    """
    predictor: Any = bench.predictor
    allowed = least**2 * weighted_residuals(predictor, values, replays).size

    def told(factors: Factors) -> bool:
        spent, changed = 0.0, with_factors(recording, factors)
        for k in range(0, len(replays), AT_ONCE):
            some = replays[k : k + AT_ONCE]
            names = [replay.name for replay in some]
            runs = tuple(run for run in changed.runs if run.name in names)
            made = bench.made(replace(changed, runs=runs), part)
            if [replay.name for replay in made] != names:
                return False  # they are not made of runs one by one
            again = [judged_like(a, b, factors) for a, b in zip(some, made, strict=True)]
            residuals = weighted_residuals(predictor, values, again)
            spent += float(residuals @ residuals)
            if spent > allowed:
                return True
        return False

    return told
