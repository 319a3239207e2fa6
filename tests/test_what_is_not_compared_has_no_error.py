"""A run of which no row counts: no error of zero, and a remark."""

from types import SimpleNamespace

import numpy as np

from simpter_hybrid.identification.fits import nothing_compared
from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.fitting.residual import predicted_errors

TIME = 0.01 * np.arange(50)


def run(name, told):
    seen = Observation(np.ones(TIME.size), 0.5, np.full(TIME.size, told))
    return Replay(name, name, TIME, {}, {"force": seen}, stamp=3.0)


RUNS = [run("slow", True), run("fast", False)]


def test_it_is_left_out_of_the_errors_by_experiment():
    predicted = {"force": [np.zeros(TIME.size)] * 2}
    assert predicted_errors(predicted, RUNS) == (2.0, {"slow": 2.0})


def test_it_is_remarked():
    bench = SimpleNamespace(parts={"fit": RUNS[:1], "report": RUNS[1:]})
    recording = SimpleNamespace(runs=[SimpleNamespace(name="fast", rows=(50, 100))])
    (found,) = nothing_compared(bench, recording)
    assert (found.run, found.value, found.row, found.time) == ("fast", "50 rows", 50, 3.0)
