from dataclasses import replace

import numpy as np
import pytest
from toy_rig import toy_replay

from simpter_hybrid.identification.fitting.floor import (
    SAME_BREAKAWAY,
    replicate_floor,
    replicate_noise,
    weighted_floor,
)
from simpter_hybrid.identification.fitting.replay import Breakaway
from simpter_hybrid.identification.fitting.replicates import merged, replicates


def test_two_runs_with_the_same_inputs_give_their_noise():
    runs = [toy_replay("1", 1, gain=0.7), toy_replay("2", 2, gain=0.7)]
    floor = replicate_floor(runs)["torque"]
    # Standard error of a standard deviation from 2000 samples: 1.6 %; four of them.
    assert floor == pytest.approx(0.1, rel=0.064)


@pytest.mark.parametrize("count", [2, 3, 4])
def test_of_more_runs_each_tells_of_it(count):
    runs = [toy_replay(str(k), k, gain=0.7) for k in range(count)]
    for order in (runs, runs[::-1]):
        noise = replicate_noise(order)
        assert len(noise) == count - 1
        # 2000 (count - 1) samples tell a standard deviation to 1.6 % over the root of count - 1.
        assert weighted_floor(order) == pytest.approx(1.0, rel=0.064 / (count - 1) ** 0.5)
        correlations = np.corrcoef([n.values for n in noise]) if count > 2 else np.eye(1)
        # 1 / sqrt(2000): four of them.
        assert np.allclose(correlations, np.eye(count - 1), atol=0.09)
    assert weighted_floor(runs) == pytest.approx(weighted_floor(runs[::-1]), rel=1e-12)


def test_what_the_experiments_of_two_runs_are_called_does_not_matter():
    runs = [toy_replay("1", 1), replace(toy_replay("2", 2), experiment="once more")]
    assert len(replicates(runs)) == 1
    assert [r.replicates for r in merged(runs)] == [2]


def test_runs_with_other_inputs_are_no_replicates():
    runs = [toy_replay("1", 1), toy_replay("2", 2, experiment="b")]
    assert replicates(runs) == []
    assert replicate_floor(runs) == {}


@pytest.mark.parametrize(("beside", "alike"), [(293.0, True), (333.0, False), (np.nan, True)])
def test_runs_of_which_one_was_warmer_all_through_are_no_replicates(beside, alike):
    cold, other = (
        replace(toy_replay("run", k), logged={"temperature": t + 0.2 * np.sin(np.arange(2000))})
        for k, t in enumerate((293.1, beside))
    )
    assert bool(replicates([cold, other])) == alike
    assert len(merged([cold, other])) == (1 if alike else 2)


def test_a_run_with_another_sensor_beside_is_no_replicate():
    more = toy_replay("2", 2)
    more = replace(more, observed={**more.observed, "motor": more.observed["torque"]})
    runs = [toy_replay("1", 1), more]
    assert replicates(runs) == [] == replicates(runs[::-1])
    assert [r.replicates for r in merged(runs)] == [1, 1]


def test_merging_keeps_the_mean_and_counts_the_runs():
    runs = [toy_replay("1", 1), toy_replay("2", 2), toy_replay("3", 3, experiment="b")]
    both, alone = merged(runs)
    assert (both.replicates, alone.replicates) == (2, 1)
    mean = (runs[0].observed["torque"].values + runs[1].observed["torque"].values) / 2
    assert np.array_equal(both.observed["torque"].values, mean)


def let_go(seed, *events):
    """A run that breaks away at some rows, at some levels."""
    return replace(toy_replay("run", seed), breakaways=tuple(Breakaway(*e, 0.1) for e in events))


def test_a_breakaway_that_one_run_misses_sets_no_other_off():
    first = let_go(1, (100, 1.0), (180, 2.0), (900, 3.0))
    for other in (let_go(2, (181, 2.0), (903, 3.0)), let_go(2, (99, 1.0), (899, 3.0))):
        for both in ([first, other], [other, first]):
            assert replicate_floor(both)["breakaway"] == 0.0


def test_breakaways_of_two_runs_are_the_same_near_one_another_and_the_same_way():
    first = let_go(1, (100, 1.0))
    for other in (let_go(2, (100 + SAME_BREAKAWAY, 1.0)), let_go(2, (100, -1.0))):
        assert "breakaway" not in replicate_floor([first, other])


def test_where_both_runs_have_all_breakaways_the_first_is_the_first():
    a, b = let_go(1, (100, 1.0), (190, 2.0)), let_go(2, (185, 1.0), (275, 2.0))
    assert replicate_floor([a, b])["breakaway"] == 0.0
