"""A force that acts anew in each run is known by a few repeated ones only roughly.

Of twelve runs of one course under white noise of a force two pairs told a floor that all that this
noise leaves exceeds by half in one case of eight.
"""

import pytest
from evidence import FLOOR, depends, judged, trial

from simpter_hybrid.identification.tracing.limits import SIMULATED_AXIS, known_by_repetition

RAISED = known_by_repetition(SIMULATED_AXIS, 1.6, 0.07)
#: It takes 7 % of the error away.
LITTLE = [trial("a", 1.4)]


@pytest.mark.parametrize("trials", [[], LITTLE])
@pytest.mark.parametrize(("ratio", "kind"), [(1.9, "lack or noise"), (3.1, "unknown")])
def test_what_depends_on_nothing_may_be_that_though_a_candidate_takes_a_little(trials, ratio, kind):
    assert judged(trials, [], [], FLOOR, ratio=ratio, limit=RAISED).kind == kind


@pytest.mark.parametrize("trials", [[], LITTLE])
def test_what_depends_on_something_is_a_lack(trials):
    before = [depends("force:speed", 0.3)]
    assert judged(trials, before, [], FLOOR, ratio=1.9, limit=RAISED).kind == "unknown"


def test_where_repeated_runs_differ_by_known_noise_it_is_a_lack():
    known = known_by_repetition(SIMULATED_AXIS, 1.0, 0.02)
    assert judged(LITTLE, [], [], FLOOR, ratio=1.9, limit=known).kind == "unknown"
