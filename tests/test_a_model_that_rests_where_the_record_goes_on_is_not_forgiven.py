"""The line that a wrong start leaves in a window counts for nothing; that of a rest does."""

from dataclasses import replace

import numpy as np
import pytest

from simpter_hybrid.identification.axis.windows import half_width, steepest
from simpter_hybrid.identification.channel_factors import judged_like
from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.fitting.residual import deviation, without_line

STEP, SD = 0.002, 1e-4
TIME = STEP * np.arange(500)
STARTS = (0, 250)
#: It goes, and then it rests.
POSITION = np.where(TIME < 0.5, 0.4 * TIME, 0.2)


def _seen(most=None):
    most = most or steepest(POSITION, STARTS, half_width(STEP), SD)
    return Observation(POSITION, SD, np.ones(500, bool), 1.0, STARTS, slopes=most)


def test_a_start_may_be_off_by_many_errors_of_its_own_speed():
    off = POSITION + np.concatenate([0.05 * TIME[:250], 0.02 * (TIME[250:] - 0.5)])
    assert np.abs(deviation(_seen(), off)).max() < 1e-12


def test_one_that_moves_may_begin_at_any_speed():
    assert np.abs(deviation(_seen(), 3.0 * POSITION)).max() < 1e-12
    assert np.abs(deviation(_seen(), 0.3 * POSITION)).max() < 1e-12


def test_the_less_it_moves_the_more_counts():
    sure = steepest(POSITION, STARTS, half_width(STEP), 1e-3 * SD)
    left = [np.ptp(deviation(_seen(sure), part * POSITION)) for part in (0.1, 0.05, 0.0)]
    assert left == sorted(left)
    assert left[0] > 0.0


def test_a_model_at_rest_leaves_half_of_the_way_that_it_does_not_go():
    sure = 1e-3 * SD  # else twenty errors of a speed are a fifth of this one
    seen = _seen(most=steepest(POSITION, STARTS, half_width(STEP), sure))
    left = deviation(seen, np.where(TIME < 0.5, 0.0, 0.2))
    assert np.ptp(left[250:]) == 0.0
    assert np.ptp(left[:250]) == pytest.approx(0.5 * np.ptp(POSITION[:250]), rel=0.01)


def test_in_another_unit_it_is_the_same():
    rests = np.where(TIME < 0.5, 0.0, 0.2)
    run = Replay("run", "run", TIME, {}, {"position": _seen()})
    times = replace(run, observed={"position": replace(_seen(), values=50.0 * POSITION)})
    again = judged_like(run, times, {"position": 50.0}).observed["position"]
    assert deviation(again, 50.0 * rests) == pytest.approx(50.0 * deviation(_seen(), rests))


def test_a_line_is_taken_away_as_far_as_it_may_be():
    line = np.linspace(-1.0, 1.0, 11)
    assert without_line(line, 0.3) == pytest.approx(0.0, abs=1e-12)
    assert without_line(line, 0.05) == pytest.approx(0.75 * line)
