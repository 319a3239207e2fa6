"""Nothing repeated, nothing located: what a sensor's noise cannot be a driver's own force can."""

import pytest
from evidence import FLOOR, depends, judged, trial

from simpter_hybrid.identification.tracing.limits import SIMULATED_AXIS, known_by_repetition

TOLD = SIMULATED_AXIS._replace(told=True)
LITTLE = [trial("a", 60.0)]


@pytest.mark.parametrize("trials", [[], LITTLE])
def test_it_cannot_be_told_from_a_lack(trials):
    assert judged(trials, [], [], FLOOR, ratio=70.0, limit=TOLD).kind == "lack or noise"
    assert judged(trials, [], [], FLOOR, ratio=70.0, limit=SIMULATED_AXIS).kind == "unknown"


def test_but_not_of_more_than_a_hundred_times_what_sensors_show():
    assert judged([], [], [], FLOOR, ratio=130.0, limit=TOLD).kind == "unknown"


@pytest.mark.parametrize("trials", [[], LITTLE])
def test_what_depends_on_something_is_a_lack(trials):
    before = [depends("force:speed", 0.3)]
    assert judged(trials, before, [], FLOOR, ratio=70.0, limit=TOLD).kind == "unknown"


def test_repeated_runs_tell():
    repeated = known_by_repetition(TOLD, 1.0, 0.02)
    assert judged([], [], [], FLOOR, ratio=70.0, limit=repeated).kind == "unknown"
