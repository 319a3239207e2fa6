"""An effect that is there lowers the error of runs held out for sure, another one does not."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from toy_rig import ALONG_X, ALONG_Y, ToyRig, toy_replay

from simpter_hybrid.identification.fitting.predictor import UNTOLD
from simpter_hybrid.identification.held_out_gains import (
    NO_INTERVAL,
    HeldOutGain,
    _gain,
    _squares,
    held_out_gains,
)
from simpter_hybrid.identification.reporting.held_out_data import gain_rows
from simpter_hybrid.identification.reporting.tables import candidate_table


def diagnosis(*rounds):
    return SimpleNamespace(rounds=rounds)


def tried(candidate, **values):
    return SimpleNamespace(candidate=candidate, fit=SimpleNamespace(values={"scale": 1.0} | values))


TOY = ToyRig()


def one_round(*trials, base=TOY, named=None, **values):
    model = SimpleNamespace(predictor=base, values={"scale": 1.0} | values)
    return SimpleNamespace(trials=trials, base=model, verdict=SimpleNamespace(accepted=named))


def test_what_is_there_gains_for_sure_and_what_is_not_does_not():
    runs = [toy_replay("held out", 7, gain=0.1)]
    along_x, along_y = tried(ALONG_X, gain=0.1), tried(ALONG_Y, other=0.002)
    ((x, y),) = held_out_gains(diagnosis(one_round(along_x, along_y)), runs)
    # Mean square 0.1^2 / 2 of the sine beside 0.1^2 of noise.
    assert x.gain == pytest.approx(1.0 - (1.0 / 1.5) ** 0.5, abs=0.03)
    assert 0.0 < x.low < x.gain < x.high
    assert y.low <= 0.0 <= y.high


def test_what_is_there_does_surely_better_than_another_that_was_named():
    runs = [toy_replay("held out", 7, gain=0.1)]
    wrong, right = tried(ALONG_Y, other=0.02), tried(ALONG_X, gain=0.1)
    ((other, there),) = held_out_gains(diagnosis(one_round(wrong, right, named=wrong)), runs)
    assert 0.0 < there.surely_beyond < there.beyond
    assert other.surely_beyond == -np.inf
    ((_, less),) = held_out_gains(diagnosis(one_round(right, wrong, named=right)), runs)
    assert less.beyond < 0.0


class Silent(ToyRig):
    """Repeats what was measured in half of the rows, where it says nothing, if it has an effect."""

    def extended(self, candidate):
        return Silent((*self.parameters, *candidate.parameters))

    def predict(self, values, replays):
        told = dict(super().predict({"scale": 1.0}, replays))
        untold = [(np.arange(r.time.size) % 2 == 0) & (len(self.parameters) > 1) for r in replays]
        told["torque"] = [
            np.where(u, r.observed["torque"].values, p)
            for u, r, p in zip(untold, replays, told["torque"], strict=True)
        ]
        return told | {UNTOLD: untold}


def test_to_say_nothing_is_no_gain():
    runs = [toy_replay("held out", 7, gain=0.1)]
    ((found,),) = held_out_gains(diagnosis(one_round(tried(ALONG_X), base=Silent())), runs)
    assert (found.gain, found.low, found.high) == (0.0, 0.0, 0.0)


def test_each_round_is_asked_from_the_model_that_it_started_with():
    runs = [toy_replay("held out", 7, gain=0.1)]
    first = one_round(tried(ALONG_X, gain=0.1))
    # Refitted since: not where the first round's best had left it.
    again = one_round(tried(ALONG_Y, gain=0.08), base=ToyRig().extended(ALONG_X), gain=0.08)
    _, ((name, gain, *_),) = held_out_gains(diagnosis(first, again), runs)
    assert (name, gain) == ("along y", 0.0)


def test_channels_that_are_compared_in_other_rows_are_cut_at_the_same_times():
    run = toy_replay("held out", 7, noise=1.0, samples=1000)
    seen = replace(run.observed["torque"], values=run.time * 0.0 + (run.time >= 9.0))
    some = replace(seen, keep=np.arange(1000) >= 800)
    both = replace(run, observed={"torque": seen, "again": some})
    nothing = {name: [0.0 * run.time] for name in both.observed}
    assert _squares(nothing, [both]).tolist() == [0.0] * 9 + [200.0]


def test_an_interval_that_few_blocks_do_not_tell_is_none():
    one = np.array([0.0, 0.0, 5.0, 0.0, 0.0]), np.array([0.0, 0.0, 3.0, 0.0, 0.1])
    for of_runs in (False, True):  # of one run that holds all nothing is left without it
        assert _gain(*one, of_runs) == (pytest.approx(1.0 - 0.62**0.5), *NO_INTERVAL)
    assert _gain(np.ones(1), np.zeros(1), of_runs=False) == (1.0, *NO_INTERVAL)


def test_no_interval_is_none_in_the_table_and_the_data():
    rows = gain_rows([HeldOutGain("wave", 0.3, *NO_INTERVAL), HeldOutGain("drag", 0.2, 0.1, 0.3)])
    assert (rows["wave"]["low"], rows["wave"]["high"]) == (None, None)
    told = {
        "port": "friction",
        "gain": 0.3,
        "idle": False,
        "by_chance": False,
        "share": 0.9,
        "values": {},
    }
    tried = [{"name": name, **told, "held_out": row} for name, row in rows.items()]
    page = candidate_table(1, {"candidates": tried, "verdict": "effect"})
    assert "30.00 % (-)" in page
    assert "20.00 % (10 to 30)" in page


def test_blocks_at_rest_that_hold_nothing_say_nothing():
    before = np.array([0.0, 1.0, 0.9, 1.1, 1.2, 0.0])
    after = np.array([0.0, 0.6, 0.5, 0.6, 0.9, 0.0])
    moving = slice(1, 5)
    without_rest = _gain(before[moving], after[moving], of_runs=False)
    assert _gain(before, after, of_runs=False) == without_rest
    assert without_rest[1] < without_rest[0] < without_rest[2]


def mean_gains(spread, count, draws):
    """Falls of `count` runs that scatter by `spread` about a fall of 0.2; how often it is held."""
    generator, held = np.random.default_rng(1), 0
    for _ in range(draws):
        before = np.ones(count)
        after = before * (0.8 + spread * generator.standard_normal(count)) ** 2
        _, low, high = _gain(before, after, of_runs=True)
        held += low <= 1.0 - np.sqrt(0.8**2 + spread**2) <= high
    return held / draws


@pytest.mark.parametrize("count", [5, 6, 12])
def test_of_many_runs_the_interval_holds_for_others(count):
    # 400 draws tell 95 % to 1.1 % (one standard error); three of them.
    assert mean_gains(0.05, count, 400) == pytest.approx(0.95, abs=0.033)


def test_pieces_of_one_run_are_no_runs():
    runs = [toy_replay(f"take {k}, part 2", k, gain=0.1) for k in range(6)]
    # Pieces of the only run are called after no other.
    for of, first, of_runs in (("", None, True), ("take 0", 1, False), ("", 1, False)):
        piece = [0 if first is None else first + k for k in range(6)]
        cut = [replace(run, cut_from=of, piece=k) for run, k in zip(runs, piece, strict=True)]
        ((found,),) = held_out_gains(diagnosis(one_round(tried(ALONG_X, gain=0.1))), cut)
        assert found.of_runs is of_runs
