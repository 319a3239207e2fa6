"""Of a force with less noise than the model's, gain and timing are put right, each once."""

import numpy as np
import pytest

from simpter_hybrid.identification.axis.prescribed_replays import CLEARER
from simpter_hybrid.identification.axis.prescribed_rig import PrescribedRig
from simpter_hybrid.identification.fitting.replay import Observation, Replay

TIME = np.arange(0.0, 2.0, 0.002)
INNER = slice(50, -50)  # at its ends a delayed record tells nothing


def _force(time):
    return 10.0 * np.sin(2.0 * np.pi * time)


@pytest.mark.parametrize("offset", [0.0, 1.0])
@pytest.mark.parametrize("gain", [0.0, 0.2])
def test_the_right_model_leaves_nothing(gain, offset):
    late = 0.02
    seen = (1.0 + gain) * _force(TIME - late) + offset
    observed = {"force": Observation(seen, 0.05, np.ones(TIME.size, dtype=bool))}
    replay = Replay("run", "e", TIME, {}, observed, notes={CLEARER: np.ones(TIME.size)})
    channels = {"force": _force(TIME)}
    errors = {"force-gain.gain": gain, "force-delay.delay": late, "force-offset.offset": offset}
    PrescribedRig().read(replay, errors, channels)
    assert channels["force"][INNER] == pytest.approx(seen[INNER], abs=1e-9)
