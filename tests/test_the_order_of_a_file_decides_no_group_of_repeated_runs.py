"""A run may be like two that are not like one another: which go together, no order decides."""

from dataclasses import replace
from itertools import permutations

import numpy as np
import pytest
from toy_rig import toy_replay

from simpter_hybrid.identification.fitting.floor import weighted_floor
from simpter_hybrid.identification.fitting.repeats import repetitions
from simpter_hybrid.identification.fitting.replay import Breakaway
from simpter_hybrid.identification.fitting.replicates import merged, replicates

ORDERS = [*permutations("abcd")]
#: Temperatures from which and to which runs went: of a, b, c each overlaps the next alone.
WARMED = {"a": (20.0, 21.0), "b": (20.5, 22.0), "c": (21.5, 23.0), "d": (20.2, 20.8)}


def _told(order):
    """Runs that were told the same: friction falls with temperature, levels of breakaway too."""
    runs = []
    for name in order:
        draw, (low, high) = np.random.default_rng(ord(name)), WARMED[name]
        levels = 5.0 - 0.2 * low + 0.1 * draw.standard_normal(9)
        one = replace(
            toy_replay(name, ord(name), scale=1.0 - 0.1 * (low - 20.0)),
            breakaways=tuple(Breakaway(200 * k, x, 0.1) for k, x in enumerate(levels, 1)),
            logged={"temperature": np.linspace(low, high, 2000)},
        )
        runs.append(one)
    return runs


def _measured(order):
    """Runs of one course whose drives differ: each from the next by a tenth."""
    sizes = dict(zip("abcd", (1.0, 1.1, 1.22, 1.05), strict=True))
    runs = [toy_replay(name, 1) for name in order]
    return [
        replace(r, drive_is_exact=False, inputs={k: sizes[r.name] * x for k, x in r.inputs.items()})
        for r in runs
    ]


def _names(groups):
    return {frozenset(run.name for run in group) for group in groups}


@pytest.mark.parametrize(("made", "grouped"), [(_told, replicates), (_measured, repetitions)])
def test_each_is_like_every_other_of_its_group(made, grouped):
    groups = {frozenset(_names(grouped(made(order)))) for order in ORDERS}
    assert groups == {frozenset({frozenset("abd")})}


def test_only_these_are_averaged():
    told = [{run.replicates for run in merged(_told(order))} for order in ORDERS]
    assert told == [{1, 3}] * len(ORDERS)


def test_nor_their_floor():
    floors = [weighted_floor(_told(order)) for order in ORDERS]
    assert floors == pytest.approx([floors[0]] * len(ORDERS), rel=1e-12)
