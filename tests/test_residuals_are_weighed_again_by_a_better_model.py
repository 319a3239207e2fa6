"""By which model the noise of inputs is weighed, and which of two searches stays."""

from types import SimpleNamespace as Some

import numpy as np
import pytest
from searches_as_told import Cut, Searching, diagnosis

from simpter_hybrid.identification import weighted_search
from simpter_hybrid.identification.fitting.effort import Effort
from simpter_hybrid.identification.next_search import better_model


@pytest.mark.parametrize(
    ("done", "names"),
    [
        (diagnosis(10.0, 4.0), ("drag",)),
        (diagnosis(10.0, 6.0), ()),  # not far enough
        (diagnosis(10.0, best=8.0), ("wear",)),  # nothing may be named, one helps
        (diagnosis(10.0, best=9.0), ()),
        (diagnosis(10.0), ()),
    ],
)
def test_the_model_to_weigh_by(done, names):
    assert better_model(done)[0] == names


def test_once_more_by_what_was_found_and_no_longer_than_that_changes():
    search = Searching(False, diagnosis(10.0, 2.0), diagnosis(12.0, 2.0))
    search.settled({})
    assert search.by == ["declared", "found"]


def test_not_by_another_form_of_what_weighed():
    tried = [Some(name=n, family="drag") for n in ("drag", "drag-2")]
    ends = diagnosis(10.0, 2.0), diagnosis(12.0, 2.0, names=("drag-2",)), diagnosis(1.0)
    search = Searching(False, *ends, tried=tried)
    search.settled({})
    assert search.by == ["declared", "found"]


def test_a_search_that_was_cut_short_takes_no_others_place():
    first, second = diagnosis(10.0, 2.0), diagnosis(10.0, 3.0, names=("wear",))
    search = Cut(False, first, second, effort=Effort(1.5))
    assert search.settled({}).search is first
    assert search.ends == []


@pytest.mark.parametrize(("error", "stays"), [(1.5, True), (14.8, False)])
def test_what_a_plain_search_found_stays_where_the_weighed_one_ends_above_it(
    monkeypatch, error, stays
):
    told = (np.float64(error), {})
    monkeypatch.setattr(weighted_search, "errors_by_experiment", lambda *given: told)
    first, second = diagnosis(20.0, 1.6), diagnosis(15.0)
    search = Searching(True, first, second)
    assert search.settled({}).search is (first if stays else second)
    assert search.by == [None, "found"]


def test_what_weighed_without_a_name_is_weighed_out_again_if_nothing_is_named():
    """A candidate that nobody named bends the curves of noise: the model's own are asked."""
    ends = diagnosis(20.0, best=9.0), diagnosis(15.0), diagnosis(1.0)
    search = Searching(True, *ends)
    assert search.settled({}).search is ends[-1]
    assert search.by[:2] == [None, "with wear"]
    assert search.by[2] is ends[1].refitted.predictor


@pytest.mark.parametrize("second", [diagnosis(2.0, 1.15), diagnosis(1.0)])
def test_what_is_at_the_floor_needs_no_patch_of_a_plain_search(monkeypatch, second):
    monkeypatch.setattr(weighted_search, "errors_by_experiment", lambda *given: (0.9, {}))
    first = diagnosis(20.0, 1.6, names=("drag", "wear"))
    assert Searching(True, first, second).settled({}).search is second
