"""What a right model scores on noise: lines take rows, breakaways weigh more than theirs."""

from dataclasses import replace

import numpy as np
import pytest
from toy_rig import toy_replay

from simpter_hybrid.identification.fitting.floor import noise_floor, weighted_floor
from simpter_hybrid.identification.fitting.replay import Breakaway, Observation
from simpter_hybrid.identification.fitting.residual import predicted_errors

SD = 0.1


def run(seed, windows=(), keep=None, events=0, rows=20000):
    """A run of noise alone; breakaways scatter as they are said to."""
    draw = np.random.default_rng(seed)
    keep = np.ones(rows, bool) if keep is None else keep
    seen = Observation(draw.normal(0.0, SD, rows), SD, keep, 1.0, windows)
    levels = 5.0 + draw.normal(0.0, 0.05, events)
    breakaways = [Breakaway(10 * (k + 1), level, 0.05) for k, level in enumerate(levels)]
    return replace(
        toy_replay("run", 0), time=np.arange(rows) * 1e-3, inputs={}, observed={"torque": seen},
        breakaways=tuple(breakaways),
    )  # fmt: skip


def error(of):
    """What a model leaves that predicts all but the noise."""
    flat = np.zeros(of.time.size)
    told = {"torque": [flat], "breakaway_torque": [flat + 5.0]}
    return predicted_errors(told, [of])[0]


@pytest.mark.parametrize("size", [10, 50])
@pytest.mark.parametrize("compared", ["all rows", "half of each window", "a window in ten"])
def test_a_line_takes_two_rows_of_a_window(size, compared):
    rows = np.arange(20000)
    kept = {
        "all rows": rows >= 0,
        "half of each window": rows % size < size // 2,
        "a window in ten": rows // size % 10 == 0,
    }[compared]
    one = run(1, tuple(range(0, 20000, size)), kept)
    # So many rows tell a deviation to 1 / sqrt(2 rows): 0.5 to 1.6 %; 2.5 of that.
    close = 2.5 / np.sqrt(2.0 * kept.sum())
    assert noise_floor([one]) == pytest.approx(error(one), rel=close)


def test_breakaways_count_as_a_fit_weighs_them():
    one = run(2, events=400)
    # 400 of them tell their scatter to 3.5 %, and are a sixth of the square.
    assert noise_floor([one]) == pytest.approx(error(one), rel=0.02)
    assert noise_floor([one]) > 1.05 * noise_floor([replace(one, breakaways=())])


def test_those_of_repeated_runs_are_in_their_floor():
    both = [run(3, events=400), run(4, events=400)]
    both = [replace(one, drive_is_exact=True) for one in both]
    assert weighted_floor(both) == pytest.approx(error(both[0]), rel=0.03)
    alone = [replace(one, breakaways=()) for one in both]
    assert weighted_floor(both) > 1.05 * weighted_floor(alone)
