"""What a model leaves untold lowers neither what a fit minimises nor the error of a run."""

import numpy as np
import pytest

from simpter_hybrid.identification.axis.prescribed_replays import CLEARER
from simpter_hybrid.identification.axis.prescribed_rig import PrescribedRig
from simpter_hybrid.identification.fitting.predictor import UNTOLD
from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.fitting.residual import (
    CLIP,
    errors_by_run,
    over_rest,
    predicted_errors,
    weighted_residuals,
)

TIME = np.arange(0.0, 10.0, 0.005)
FORCE = np.where((TIME // 0.25) % 2 == 0, 5.0, -5.0)
#: The first 50 ms of every stroke are not compared, so a late model does not tell the next ones.
KEEP = TIME % 0.25 > 0.05


class LateRig:
    """The right force through a sensor that a model calls late."""

    parameters = ()

    def predict(self, values, replays):
        made = [{"force": FORCE.copy()} for _ in replays]
        for replay, channels in zip(replays, made, strict=True):
            PrescribedRig().read(replay, values, channels)
        return {name: [one[name] for one in made] for name in made[0]}


def _run():
    seen = FORCE + 0.1 * np.random.default_rng(0).standard_normal(TIME.size)
    observed = {"force": Observation(seen, 0.1, KEEP)}
    return Replay("run", "e", TIME, {}, observed, notes={CLEARER: np.zeros(TIME.size)})


def _cost(late, run):
    residuals = weighted_residuals(LateRig(), {"force-delay.delay": late}, [run])
    return float(residuals @ residuals)


def test_a_delay_that_is_none_costs_what_no_delay_costs():
    run = _run()
    assert _cost(0.04, run) == pytest.approx(_cost(0.0, run), rel=0.02)


def test_the_cost_does_not_jump_where_a_delay_begins():
    run = _run()
    assert _cost(1e-7, run) == pytest.approx(_cost(0.0, run), rel=1e-5)


def test_the_error_of_a_run_is_that_of_what_is_told():
    run = _run()
    predicted = LateRig().predict({"force-delay.delay": 0.04}, [run])
    assert errors_by_run(predicted, [run])[0] == predicted_errors(predicted, [run])[0]


def test_what_tells_nothing_is_as_wrong_as_can_be():
    run = _run()
    predicted = LateRig().predict({"force-delay.delay": 0.04}, [run])
    predicted[UNTOLD] = [np.ones(TIME.size)]
    assert over_rest(predicted, [run]) == np.inf

    class Silent(LateRig):
        def predict(self, values, replays):
            return predicted

    assert (weighted_residuals(Silent(), {}, [run]) == CLIP).all()
