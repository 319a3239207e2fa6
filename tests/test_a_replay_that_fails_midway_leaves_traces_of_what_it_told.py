"""A model may fail in one of many replays: its error there is the worst, and nothing breaks."""

import numpy as np

from simpter_hybrid.identification.fitting.replay import Breakaway, Observation, Replay
from simpter_hybrid.identification.fitting.residual import CLIP, weighted_residuals
from simpter_hybrid.identification.rotor.traces import RotorTracer

TIME = 2e-3 * np.arange(1, 1001)
FAILS = 600


class FailsMidway:
    """Predicts a torque of 1 N*m, and nothing after 1.2 s."""

    def predict(self, values, replays):
        told = np.where(np.arange(TIME.size) < FAILS, 1.0, np.nan)
        names = ("clutch_torque", "speed", "excitation", "breakaway_torque")
        return {name: [told] for name in names}


def test_traces_are_finite_and_the_error_after_the_failure_is_the_worst():
    torque = np.full(TIME.size, 1.2)
    seen = Observation(torque, 0.1, np.ones(TIME.size, bool))
    inputs = {name: np.ones(TIME.size) for name in ("command", "neighbour_command")}
    inputs["reference_torque"] = torque
    breakaways = tuple(Breakaway(k, 1.2, 0.1, 1.0) for k in (100, 300, 500, 700))
    replay = Replay(
        "run", "run", TIME, inputs, {"clutch_torque": seen}, (), breakaways,
        notes={"position": TIME},
    )  # fmt: skip
    found = RotorTracer(0.1, 0.1)(FailsMidway(), {}, [replay])
    for traces in found.values():
        for trace in traces:
            assert np.isfinite(trace.residual).all()
            assert all(np.isfinite(c).all() for c in trace.coordinates.values())
    (levels,) = found["breakaway"]
    assert levels.residual.size == 3
    assert (weighted_residuals(FailsMidway(), {}, [replay])[FAILS : TIME.size] == CLIP).all()
