"""Where a run comes to rest hardly changes with friction until it changes by a whole half swing."""

from dataclasses import dataclass

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.fit import Fitter
from simpter_hybrid.identification.fitting.predictor import Parameter
from simpter_hybrid.identification.fitting.replay import Observation, Replay, Restart

TIME = np.linspace(0.0, 3.0, 40)
#: Wider than a narrow step from the start reaches (half of 0.1), narrower than a wide one (0.2).
STAIR = 0.15


@dataclass(frozen=True)
class Stairs:
    """A level that goes by whole stairs."""

    parameters: tuple[Parameter, ...] = (Parameter("level", 0.92, 0.0, 9.0, 0.1),)

    def predict(self, values, replays):
        return {"row": [np.full(TIME.size, STAIR * (values["level"] // STAIR)) for _ in replays]}


@pytest.mark.parametrize("followed", [True, False])
def test_narrow_steps_see_one_stair(followed):
    seen = Observation(np.full(TIME.size, 1.95), 0.1, np.ones(TIME.size, bool))
    anew = (Restart(1, 0.0, 0.0),) if followed else ()
    fitter = Fitter(Stairs(), [Replay("1", "a", TIME, {}, {"row": seen}, followed=anew)])
    reached = fitter.fit({"level": 0.92}, iterations=20).values["level"]
    # In windows nothing is carried along, and no fit pays for wide columns.
    assert abs(reached - 1.95) < STAIR if followed else reached == 0.92
