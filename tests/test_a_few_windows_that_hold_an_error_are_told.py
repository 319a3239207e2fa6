"""Where a few windows hold what runs held out leave, a reader is told which, to look at them."""

from types import SimpleNamespace as Some

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.floor import Floors
from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.reporting.few_windows import few_windows_sentence
from simpter_hybrid.identification.tracing.limits import REPEATED

#: 40 windows of 25 samples; residuals are noise of size 1.
WINDOWS, SAMPLES = 40, 25


def told(*wrong, selecting=1.0):
    """A run held out of which these windows are 10 times farther off than the selecting runs."""
    values = selecting * np.random.default_rng(1).standard_normal(WINDOWS * SAMPLES)
    for k in wrong:
        values[k * SAMPLES : (k + 1) * SAMPLES] += 10.0 * selecting
    starts = tuple(range(0, values.size, SAMPLES))
    seen = Observation(values, 1.0, np.ones(values.size, bool), windows=starts, lines=False)
    time = 0.02 * np.arange(values.size)
    run = Replay("cycle 7", "cycle 7", time, {}, {"speed": seen})
    error = float(np.sqrt(np.mean(values**2)))
    done = Some(corrected=Some(select_error=selecting, effects=()), floor=1.0)
    floors = Floors(1.0, 1.0, 1.0)
    found = Some(search=done, error_by_stage={"after": error}, floors=floors, limits=REPEATED)
    return found, Some(after={"speed": [0.0 * values]}, replays=[run])


def test_they_are_named_where_the_rest_is_as_the_runs_that_select():
    said = few_windows_sentence(*told(6, 30))
    assert "Without 2 of 40 windows" in said
    assert "cycle 7 from 3 s" in said
    assert "cycle 7 from 15 s" in said


@pytest.mark.parametrize("wrong", [(), (6, 20, 30)])
def test_where_none_or_more_than_a_twentieth_are_off_nothing_is_said(wrong):
    assert few_windows_sentence(*told(*wrong)) == ""


def test_where_the_rest_is_noise_nothing_more_need_be_missing():
    assert few_windows_sentence(*told(6, 30)).endswith("and nothing more need be missing.")


def test_where_all_runs_leave_more_than_noise_it_is_not_said_so():
    said = few_windows_sentence(*told(6, 30, selecting=20.0))
    assert said.endswith("and the rest shows no more than the runs that select do.")
