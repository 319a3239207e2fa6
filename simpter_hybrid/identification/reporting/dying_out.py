"""That time stands for the size of a motion in runs in which it swings less and less."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import chain

import numpy as np
from scipy.stats import spearmanr

from ..fitting.replay import Replay
from ..result import Diagnosis
from ..tracing.named import coordinate_of
from ..tracing.verdict import GROWING
from .recorded_speeds import recorded_speeds

#: Over all runs together the sizes of swings go by the time if their rank correlation is beyond
#: this: of decays from sizes that differ by up to 1.3 times it is -0.96 to -1, from one size and a
#: fifth of it -0.5 to -0.76.
TOGETHER = -0.95
#: So few swings one after the other are each less than that before in one case of 120 by chance.
FEWEST = 5
#: A swing is faster than this part of the fastest one, and so is a coordinate that swings: what is
#: less is noise about rest.
MOVING = 0.05


def dying_out_sentence(found: Diagnosis) -> str:
    """Sentence that what goes by time may go by the size of the motion; "" where that is told.

    A pendulum in water, let go from the same angle in each run, was said to lack what depends on
    time: its drag grew with the square of the speed.
    """
    done = found.search
    effects = [set(map(coordinate_of, e.coordinates)) for e in done.corrected.effects]
    slow = [names for names in effects if names and names <= {*GROWING}]
    told = {coordinate_of(c) for c in done.verdict.coordinates}.union(*slow) & {*GROWING}
    runs = (*found.split.fit, *found.split.select)
    if not told or done.verdict.kind == "nothing missing" or not dies_out(runs):
        return ""
    on = " and ".join(c for c in GROWING if c in told)
    return (
        "In the runs that fit and select it swings less and less with time: whether what is told "
        f"to go by {on} does so, or by how far or how fast it swings, they do not tell. Runs that "
        "begin with smaller swings would."
    )


def dies_out(replays: Iterable[Replay]) -> bool:
    """Whether over all runs together recorded swings are the smaller the later they are.

    Those of every coordinate that swings: one that swings on tells time from the size of its
    motion, and one at rest tells nothing.
    """
    # A piece of a run goes on from those before it, and of two such the later one knows more.
    whole = {piece[0].name: piece for piece in sorted(map(_since_beginning, replays), key=len)}
    runs = [swings for pieces in whole.values() if (swings := _swings(pieces))]
    together = [list(chain.from_iterable(swings)) for swings in zip(*runs, strict=False)]
    fastest = [max((size for _, size in swings), default=0.0) for swings in together]
    least = MOVING * max(fastest, default=0.0)
    moved = [swings for swings, most in zip(together, fastest, strict=True) if most > least]
    return bool(moved) and all(map(_shrink, moved))


def _shrink(swings: Sequence[tuple[float, float]]) -> bool:
    """Whether swings of one coordinate are the smaller the later they are."""
    most = max((size for _, size in swings), default=0.0)
    times, sizes = np.array([s for s in swings if s[1] > MOVING * most]).reshape(-1, 2).T
    if sizes.size < FEWEST or np.ptp(times) == 0.0 or np.ptp(sizes) == 0.0:
        return False
    return bool(spearmanr(times, sizes).statistic <= TOGETHER)


def _since_beginning(replay: Replay) -> list[Replay]:
    """The pieces of a run up to this one, in order."""
    pieces = [replay]
    while pieces[0].before is not None:
        pieces.insert(0, pieces[0].before)
    return pieces


def _swings(pieces: Sequence[Replay]) -> list[list[tuple[float, float]]]:
    """Of each coordinate: when it is fastest in each motion one way [s], and how fast.

    None that goes on beyond the rows.
    """
    time = np.concatenate([piece.stamp - pieces[0].stamp + piece.time for piece in pieces])
    courses = zip(*map(recorded_speeds, pieces), strict=False)
    return [_turns(time, np.concatenate(speeds)) for speeds in courses]


def _turns(time: np.ndarray, speed: np.ndarray) -> list[tuple[float, float]]:
    ways = np.split(np.arange(speed.size), np.flatnonzero(np.diff(np.sign(speed))) + 1)
    fastest = (way[np.argmax(np.abs(speed[way]))] for way in ways if way.size)
    return [(float(time[k]), float(abs(speed[k]))) for k in fastest if 0 < k < speed.size - 1]
