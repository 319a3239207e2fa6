import numpy as np
import pytest

from simpter_hybrid.identification.fitting.replay import Replay
from simpter_hybrid.identification.rotor.rig import RotorRig

TIME = 0.002 * np.arange(1, 500)


@pytest.mark.parametrize("late", [{}, {"sensor lag.lag": 0.01}, {"sensor delay.delay": 0.01}])
def test_it_shows_from_the_first_row_on(late):
    rig = RotorRig()
    run = Replay("run", "run", TIME, {}, {})

    def read(values):
        channels = {rig.signals.transmitted: np.sin(3.0 * TIME), "breakaway_torque": 0.0 * TIME}
        rig.read(run, values, channels)
        return channels[rig.signals.transmitted]

    moved = read({**late, "sensor offset.offset": 0.3}) - read(late)
    assert moved == pytest.approx(np.full(TIME.size, 0.3), abs=1e-12)  # rounding alone
