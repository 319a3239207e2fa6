"""A model that fails over the recorded runs is an error, no lack of what was recorded."""

import numpy as np
import pytest
from toy_rig import ToyRig, toy_replay

from simpter_hybrid.identification.fitting.simulated import check_simulated
from simpter_hybrid.problems import InvalidInput


class Failing(ToyRig):
    """Stops after a part of every run."""

    def predict(self, values, replays):
        found = super().predict(values, replays)
        for series in found["torque"]:
            series[int(values["until"] * series.size) :] = np.nan
        return found


def test_what_fails_through_most_of_the_runs_is_named():
    run = toy_replay("run", 1)
    with pytest.raises(InvalidInput, match="80 % of the samples"):
        check_simulated(Failing(), {"scale": 1.0, "until": 0.2}, [run], "model.toml")
    check_simulated(Failing(), {"scale": 1.0, "until": 0.8}, [run], "model.toml")
