"""One kind of run alone shows an effect at the floor; far below it that is what runs differ by."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from toy_rig import ALONG_X, ToyRig, toy_replay, tracer

from simpter_hybrid.identification.fitting.fitted_model import Split, largest_fall, refitted
from simpter_hybrid.identification.tracing.limits import REPEATED, SINGLE
from simpter_hybrid.identification.tracing.rivals import (
    LEAST_AT_ESTIMATE,
    LEAST_BELOW,
    LEAST_IF_SENSED,
)
from simpter_hybrid.identification.tracing.round import _least
from simpter_hybrid.identification.tracing.rounds import search_effects

#: In one of ten runs that fit and select: 0.9 % of all, 9 % of that one.
GAIN = 0.06


def _found(floor, selecting=GAIN, limit=REPEATED):
    def run(seed, shown):
        gain = (GAIN if seed < 10 else selecting) if shown else 0.0
        replay = toy_replay("run", seed, gain=gain, experiment="ab"[shown])
        inputs = replay.inputs | ({} if shown else {"x": np.zeros(replay.time.size)})
        return replace(replay, inputs=inputs)

    parts = [[run(10 * k + j, j == 0) for j in range(10)] for k in range(2)]
    split = Split(*parts, [run(99, True)])
    declared = refitted(ToyRig(), split)
    return search_effects(declared, [ALONG_X], split, tracer, floor, limit=limit)


def test_at_the_floor_one_kind_of_run_is_enough():
    found = _found(1.0)
    assert [e.name for e in found.corrected.effects] == ["along x"]
    best = found.rounds[0].best
    assert best is not None
    assert best.gain < 0.02


def test_far_below_it_nothing_is_named():
    assert not _found(1.6).corrected.effects


def test_what_helps_one_run_and_not_its_like_helps_by_chance():
    before, after = {"a": 1.0, "b": 1.0}, {"a": 0.9, "b": 0.99}
    assert largest_fall(before, after) == pytest.approx(0.1)
    assert largest_fall(before, after, {"a": -0.02, "b": 0.02}) == pytest.approx(0.01)
    # Of a kind that no fitted run is of nothing more is known.
    assert largest_fall(before, after, {"b": 0.02}) == pytest.approx(0.1)


def test_a_trial_counts_what_one_kind_of_run_shows_in_both_parts():
    best = _found(1.0, selecting=0.1).rounds[0].best
    assert best is not None
    # 0.06 sin of noise 0.1: a fall of 1 - 1 / sqrt(1.18) = 8 %, known to 1.6 % of 2000 rows each.
    # Of the selecting run, with 0.1, it would be 1 - sqrt(1.08 / 1.5) = 15 %.
    assert best.local == pytest.approx(0.08, abs=0.03)


@pytest.mark.parametrize(("limit", "asked"), [(REPEATED, LEAST_BELOW), (SINGLE, LEAST_AT_ESTIMATE)])
def test_below_a_floor_more_is_asked_and_most_where_a_sensor_saw_the_drive(limit, asked):
    base = SimpleNamespace(effects=(), select_error=0.85)
    assert _least(base, 1.0, limit) == asked
    assert _least(base, 1.0, SINGLE._replace(drive=True)) == LEAST_IF_SENSED
