from dataclasses import replace

import numpy as np
import pytest

from simpter_hybrid.identification.deviations import scaled
from simpter_hybrid.identification.fitting.floor import noise_floor
from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.fitting.residual import rms, weighted_residuals

SAMPLES = 20000


class Two:
    """Two channels that are predicted as they are, less what is wrong with each."""

    def predict(self, values, replays):
        return {c: [np.full(r.time.size, values[c]) for r in replays] for c in ("torque", "speed")}


def recorded():
    generator = np.random.default_rng(1)
    sd, weight = {"torque": 0.2, "speed": 3.0}, {"torque": 1.0, "speed": 0.3}
    keep = np.arange(SAMPLES) % 4 > 0  # of the speed fewer samples are compared
    seen = {
        c: Observation(
            sd[c] * generator.standard_normal(SAMPLES), sd[c],
            keep if c == "speed" else np.ones(SAMPLES, bool), weight[c],
        )
        for c in sd
    }  # fmt: skip
    return Replay("run", "a", np.arange(SAMPLES) * 0.01, {}, seen, drive_is_exact=False)


@pytest.mark.parametrize("wrong", [{"torque": 6.0}, {"speed": 90.0}, {"torque": 1.0, "speed": 9.0}])
def test_whichever_channel_the_declared_model_has_wrong(wrong):
    right = {"torque": 0.0, "speed": 0.0}
    parts = scaled({"fit": [recorded()]}, Two(), right | wrong)
    error = rms(weighted_residuals(Two(), right, parts["fit"]))
    # 35000 samples of noise tell their root mean square to 1/sqrt(70000), and those of one channel
    # that counts alone to 1/sqrt(30000); none is clipped at 12 deviations.
    assert error == pytest.approx(noise_floor(parts["fit"]), rel=3 / np.sqrt(30000))


def test_of_runs_that_were_repeated_nothing_is_scaled():
    told = replace(recorded(), drive_is_exact=True)
    parts = scaled({"fit": [told, told]}, Two(), {"torque": 6.0, "speed": 0.0})
    assert [o.own for r in parts["fit"] for o in r.observed.values()] == [1.0] * 4
