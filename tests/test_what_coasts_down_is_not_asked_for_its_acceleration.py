"""Of what nothing drives the acceleration is a function of the speed: it is no rival of that."""

from types import SimpleNamespace as Some

import numpy as np
import pytest

from simpter_hybrid.identification.axis.traces import AxisTracer
from simpter_hybrid.identification.fitting.replay import Replay
from simpter_hybrid.identification.tracing.trace import Trace
from simpter_hybrid.identification.tracing.traced import Traced, mistakable


def traces(drive, missing):
    """Two coast-downs from other speeds; a drag of the square of the speed takes `missing` away."""
    found = []
    for start in (3.0, 2.0):
        speed = np.linspace(start, 0.2, 400)
        along = {
            "slip_velocity": speed,
            "direction": np.ones(400),
            "acceleration": -1.0 - speed**2,
        }
        found.append(Trace(missing * speed**2, drive + 0.0 * speed, along))
    return {"force": found}


@pytest.mark.parametrize(("drive", "asked"), [(0.0, False), (1.0, True)])
def test_it_is_a_rival_only_of_what_is_driven(drive, asked):
    before, after = (
        Traced(runs, runs, {"force": ()})
        for runs in (traces(drive, missing) for missing in (-1.0, 0.0))
    )
    drag = Some(coordinates=("force:slip_velocity",))
    assert ("force:acceleration" in mistakable(drag, before, after)) is asked


@pytest.mark.parametrize(
    ("turn", "drive", "asked"), [(0.0, 0.0, False), (np.inf, 0.0, True), (0.0, 1.0, True)]
)
def test_it_is_no_coordinate_of_one_whose_place_nobody_knows(turn, drive, asked):
    time = 0.01 * np.arange(400)
    speed, nothing = 3.0 * np.exp(-time), np.zeros(400)
    inputs = {"drive": drive + nothing, "press": nothing}
    run = Replay(
        "coast", "coast", time, inputs, {}, notes={"position": 3.0 - speed, "speed": speed}
    )
    along = AxisTracer(1.0, turn)._along(run, nothing, nothing)
    assert ("acceleration" in along) is asked
    assert "slip_velocity" in along
