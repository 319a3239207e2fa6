"""A run that begins under a held command has had it for long: a second lag has followed it."""

from dataclasses import replace

import numpy as np
import pytest
from axis_recordings import MODEL

from simpter_hybrid.compiled import simulate as compiled
from simpter_hybrid.effects.second_lag import SecondLag
from simpter_hybrid.effects.wear_in import WearIn
from simpter_hybrid.engine import simulate
from simpter_hybrid.files.scenario_file import parse

LAG = SecondLag(clutch=0, lag=0.5)


def _scenario(excitation):
    declared = parse(MODEL)
    clutch = replace(declared.clutches[0], time_constant=0.05, threshold=0.0)
    return replace(
        declared, clutches=(clutch,), controllers=(), loads=(), period=0.0, effects=(LAG,),
        command=(excitation,), excitation=(excitation,), t_end=0.1,
    )  # fmt: skip


@pytest.mark.parametrize("engine", [simulate, compiled])
@pytest.mark.parametrize("excitation", [0.0, 3.0])
def test_in_both_engines(engine, excitation):
    run = engine(_scenario(excitation))
    n, m = 1, 1
    # No command changes, so what has followed it stays where it is.
    assert run.end[2 * n + m] == pytest.approx(excitation, abs=1e-12)


def test_states_that_follow_nothing_begin_at_zero():
    worn = WearIn(clutch=0, change=0.2)
    scenario = replace(_scenario(3.0), effects=(worn, LAG))
    y, _ = scenario.initial(np.zeros, lambda k: np.zeros(k, int))
    n, m = 1, 1
    distance, follower = y[2 * n + m : 2 * n + m + 2]
    assert (distance, follower) == (0.0, 3.0)
