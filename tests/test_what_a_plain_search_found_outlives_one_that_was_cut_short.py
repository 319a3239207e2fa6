"""An interrupted diagnosis tells what its first search found, not how far its second one came."""

import pytest
from searches_as_told import Cut, diagnosis

from simpter_hybrid.identification import weighted_search
from simpter_hybrid.identification.fitting.effort import Effort


def test_no_other_begins_once_the_effort_is_used_up():
    search = Cut(True, diagnosis(20.0, 2.0), diagnosis(9.0), effort=Effort(0.5))
    settled = search.settled({})
    assert settled.search.corrected.select_error == 2.0
    assert not settled.unfinished
    assert search.by == [None]


@pytest.mark.parametrize("first", [diagnosis(20.0, 4.0), diagnosis(20.0, best=4.0)])
def test_it_stays_beside_one_that_has_found_nothing_yet(first):
    search = Cut(True, first, diagnosis(9.0), effort=Effort(1.5))
    settled = search.settled({})
    assert settled.search is first
    assert settled.unfinished


@pytest.mark.parametrize("second", [diagnosis(9.0, 2.0, names=("wear",)), diagnosis(1.0)])
def test_it_does_not_beside_one_that_has_found_something_or_that_nothing_is_missing(
    second, monkeypatch
):
    monkeypatch.setattr(weighted_search, "errors_by_experiment", lambda *given: (2.5, {}))
    search = Cut(True, diagnosis(20.0, 4.0), second, effort=Effort(1.5))
    settled = search.settled({})
    assert settled.search is second
    assert not settled.unfinished
