"""The second half of a run begins with the window that begins nearest the middle."""

import numpy as np

from simpter_hybrid.identification.axis.halves import halves, middle_of
from simpter_hybrid.identification.fitting.replay import Observation, Replay, Restart

TIME = np.arange(101) * 0.01


def _run(*starts, first=0, **more):
    restarts = tuple(Restart(k, float(k), 0.0) for k in starts)
    seen = Observation(TIME, 0.1, np.arange(TIME.size) >= first)
    notes = {"position": TIME, "start": np.zeros(2)}
    return Replay("run", "run", TIME, {}, {"position": seen}, restarts, notes=notes, **more)


def test_of_two_starts_late_in_a_run_the_first_is_taken():
    first, second = halves(_run(55, 97))
    assert (first.time.size, second.time.size) == (55, 46)


def test_of_starts_that_come_late_the_middle_of_the_list_is_not():
    assert middle_of(_run(50, 80, 85, 90)).index == 50


def test_a_run_that_is_followed_whole_is_cut_alike():
    followed = tuple(Restart(k, 0.0, 0.0) for k in (55, 97))
    assert middle_of(_run(followed=followed)).index == 55


def test_what_is_not_compared_does_not_count():
    assert middle_of(_run(50, 70, first=40)).index == 70
