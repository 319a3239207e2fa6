"""One piece of a recording may hold no motion at all."""

import numpy as np

from simpter_hybrid.identification.axis.position_waves import end_met, strongest_waves
from simpter_hybrid.identification.fitting.replay import Replay

TIME = 0.01 * np.arange(400)


def test_and_is_no_crash():
    still = np.zeros(TIME.size)
    inputs = dict.fromkeys(("drive", "released", "press", "holds"), still)
    run = Replay("run", "run", TIME, inputs, {}, notes={"position": still, "speed": still})
    assert strongest_waves([run]) is None
    assert end_met([run], 1.0) is None
