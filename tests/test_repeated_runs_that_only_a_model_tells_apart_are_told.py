"""Where records of repeated runs are alike it is the model alone that tells them apart."""

from types import SimpleNamespace as Some

import numpy as np
import pytest
from axis_recordings import MAP, SPEED, written

from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.fitting.floor import Floors
from simpter_hybrid.identification.reporting.told_apart import (
    repeated_sentence,
    told_apart_by_the_model,
)

ROWS, NOISE = 600, 0.01


def found(folder, apart=1.0, burst=0.0):
    """Two runs with one course, a third with another; of the second the model errs by `apart`.

    Its torque differs for a tenth of a second by `burst` times the noise.
    """
    draw, rows = np.random.default_rng(3), ["take,ms,angle,torque,rate"]
    for take, often in enumerate((0.05, 0.05, 0.02)):
        for k in range(ROWS):
            torque = np.sin(often * k) + NOISE * draw.standard_normal()
            torque += burst * NOISE * (take == 1 and 300 <= k < 325)
            rate = np.cos(often * k) + NOISE * draw.standard_normal()
            angle = np.degrees(np.sin(often * k) * 0.004 / often)
            rows.append(f"{take},{4 * k},{angle:.5f},{torque:.5f},{rate:.5f}")
    recording = written(folder, rows, MAP + SPEED)
    replays = axis_replays(recording, AxisSignals())

    wrong = Some(predict=lambda values, runs: {
        "speed": [r.observed["speed"].values + apart * NOISE * (r is replays[1]) for r in runs]
    })  # fmt: skip
    search = Some(corrected=Some(predictor=wrong, values={}))
    split, floors = Some(select=replays[1:]), Floors(1.0, 9.0, 1.0)
    run = Some(search=search, fitted=replays[:1], split=split, floors=floors, over_noise=9.0)
    return run, recording


def test_by_a_model_that_errs_in_one_alone(tmp_path):
    (names,) = told_apart_by_the_model(*found(tmp_path, apart=20.0))
    assert len(names) == 2


@pytest.mark.parametrize(("apart", "burst"), [(1.0, 0.0), (20.0, 10.0)])
def test_not_where_it_errs_alike_or_something_else_acted_for_a_moment(tmp_path, apart, burst):
    assert told_apart_by_the_model(*found(tmp_path, apart, burst)) == ()


def test_then_no_load_is_asked_for_and_the_floor_is_said_to_be_too_high():
    said = repeated_sentence((("a", "b"),), 8.5, (("a", "b"),))
    assert "The records of a and b differ by no more than their sensors' noise" in said
    assert "a load" not in said
    both = repeated_sentence((("a", "b"), ("c", "d")), 8.5, (("a", "b"),))
    assert "If something else was not the same in the others (another device, a load)" in both
