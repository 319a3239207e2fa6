"""A run of which no row counts: no error of zero, and a remark."""

from types import SimpleNamespace

import numpy as np

from simpter_hybrid.identification.fits import nothing_compared
from simpter_hybrid.identification.fitting.floor import Floors
from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.reporting.held_out_data import errors_of_experiments

TIME = 0.01 * np.arange(50)


def run(name, told):
    seen = Observation(np.ones(TIME.size), 0.5, np.full(TIME.size, told))
    return Replay(name, name, TIME, {}, {"force": seen}, stamp=3.0)


RUNS = [run("slow", True), run("fast", False)]


def test_it_is_left_out_of_the_errors_by_experiment():
    told = {"after": {"slow": 2.0, "fast": 0.0}}
    found = SimpleNamespace(
        split=SimpleNamespace(report=RUNS), error_by_experiment=told, fitted=RUNS,
        floors=Floors(1.0, 1.0, 1.0),
    )  # fmt: skip
    assert list(errors_of_experiments(found)) == ["slow"]


def test_it_is_remarked():
    bench = SimpleNamespace(parts={"fit": RUNS[:1], "report": RUNS[1:]})
    recording = SimpleNamespace(runs=[SimpleNamespace(name="fast", rows=(50, 100))])
    (found,) = nothing_compared(bench, recording)
    assert (found.run, found.value, found.row, found.time) == ("fast", "50 rows", 50, 3.0)
