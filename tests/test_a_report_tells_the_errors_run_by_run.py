"""Runs that fit and select, each with what the refitted and the corrected model leave of it."""

from types import SimpleNamespace

import numpy as np

from simpter_hybrid.identification.fitting.floor import Floors
from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.reporting.run_errors import LISTED, errors_of_runs, run_table

TIME = 0.01 * np.arange(50)


class Still:
    """Predicts a value everywhere."""

    parameters = (SimpleNamespace(name="at", value=0.5),)

    def predict(self, values, replays):
        return {"position": [np.full(r.time.size, values["at"]) for r in replays]}


def run(name, at):
    seen = Observation(np.full(TIME.size, at), 0.5, TIME >= 0.0)
    return Replay(name, name, TIME, {}, {"position": seen})


def test_over_the_floor_of_their_part():
    models = [SimpleNamespace(predictor=Still(), values={"at": at}) for at in (0.0, 1.0)]
    found = SimpleNamespace(
        search=SimpleNamespace(refitted=models[0], corrected=models[1]),
        split=SimpleNamespace(fit=[run("a", 1.0), run("b", 2.0)], select=[run("c", 3.0)]),
        floors=Floors(2.0, 4.0, 1.0),
    )
    told = errors_of_runs(found)
    assert told["fit"] == [
        {"run": "a", "experiment": "a", "declared": 0.5, "refitted": 1.0, "after": 0.0},
        {"run": "b", "experiment": "b", "declared": 1.5, "refitted": 2.0, "after": 1.0},
    ]  # fmt: skip
    assert told["select"] == [
        {"run": "c", "experiment": "c", "declared": 1.25, "refitted": 1.5, "after": 1.0}
    ]


def test_of_many_the_worst_are_listed():
    errors = {"declared": 2.0, "refitted": 1.0}
    many = [{"run": f"run {k}", **errors, "after": float(k)} for k in range(LISTED + 9)]
    page = run_table({"fit": many, "select": []})
    assert f"The {LISTED} with the largest errors, of {LISTED + 9}." in page
    assert "run 38" in page
    assert "<td>run 8</td>" not in page
