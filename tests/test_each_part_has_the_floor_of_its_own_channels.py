"""A speed set anew from the record weighs little: the kinds of runs of a part tell its floor."""

from dataclasses import dataclass, replace

import numpy as np
import pytest
from toy_rig import ToyRig, tracer

from simpter_hybrid.identification.fitting.replay import Observation, Replay, Restart
from simpter_hybrid.identification.rigs.bench import Bench
from simpter_hybrid.identification.weighted_search import WeightedSearch

ROWS, WEIGHT = 4000, 0.3
#: True noise of each channel, in times what its sensor is said to have.
TIMES = {"torque": 1.0, "speed": 1.4}
#: So many rows tell a root mean square to 1.2 %; three of them.
CLOSE = 0.036


@dataclass(frozen=True)
class TwoChannels(ToyRig):
    """A torque, and a speed that is as large."""

    def predict(self, values, replays):
        torque = super().predict(values, replays)["torque"]
        return {"torque": torque, "speed": torque}


def run(seed, kind):
    """A run of which the torque is compared, or the speed, or both."""
    draw, time = np.random.default_rng(seed), np.arange(ROWS) * 0.01
    u = 1.0 + 0.5 * np.sin(time + len(kind))
    inputs = {"u": u, "x": np.sin(2.3 * time), "y": np.cos(5.1 * time)}
    observed = {}
    for channel, weight in (("torque", 1.0), ("speed", WEIGHT)):
        values = u + 0.1 * TIMES[channel] * draw.standard_normal(ROWS)
        keep = np.full(ROWS, channel in kind)
        observed[channel] = Observation(values, 0.1, keep, weight)
    return Replay(kind, kind, time, inputs, observed)


def searched(fit, select):
    parts = {
        name: [run(100 * k + j, kind) for j, kind in enumerate(kinds)]
        for k, (name, kinds) in enumerate({"fit": fit, "select": select, "report": fit}.items(), 1)
    }
    bench = Bench(parts, TwoChannels(), lambda runs: tracer, (), None)
    search = WeightedSearch(bench, (), parts, {"scale": 1.0}, lambda said: None)
    return search.weighed_by(None, {"scale": 1.0})


@pytest.mark.parametrize(
    "fit",
    [
        pytest.param(["torque", "speed", "speed"], id="little speed"),
        pytest.param(["torque", "speed", "torque", "speed"], id="all"),
    ],
)
@pytest.mark.parametrize("select", [["torque"], ["speed"], ["torque and speed"]])
def test_whichever_kinds_of_runs_were_repeated(fit, select):
    found = searched(fit, select)
    left = found.search.refitted.select_error
    assert found.floors.select == pytest.approx(left, rel=2 * CLOSE)
    assert found.search.verdict.kind == "nothing missing"


def test_a_channel_that_was_not_repeated_has_the_noise_of_its_sensor():
    found = searched(["torque", "speed", "speed"], ["torque"])
    assert found.floors.select == pytest.approx(1.0, rel=1e-9)


@pytest.mark.parametrize("select", ["torque", "speed"])
def test_without_repetitions_by_the_sensors_noise(select):
    found = searched(["torque", "speed"], [select])
    assert found.floors.select == pytest.approx({"torque": 1.0, "speed": WEIGHT}[select])


def test_fitted_runs_that_are_averaged_count_once():
    # Torques are averaged, runs that are set anew are not.
    fit = [run(k, "torque") for k in (1, 2)]
    fit += [replace(run(k, "speed"), restarts=(Restart(0, 0.0, 0.0),)) for k in (3, 4)]
    parts = {"fit": fit, "select": fit, "report": fit}
    bench = Bench(parts, TwoChannels(), lambda runs: tracer, (), None)
    search = WeightedSearch(bench, (), parts, {"scale": 1.0}, lambda said: None)
    floors = search.weighed_by(None, {"scale": 1.0}).floors
    speed = (WEIGHT * TIMES["speed"]) ** 2
    expected = np.sqrt((1.0 + 2.0 * speed) / 3.0), np.sqrt((1.0 + speed) / 2.0)
    assert (floors.fit, floors.select) == pytest.approx(expected, rel=CLOSE)
