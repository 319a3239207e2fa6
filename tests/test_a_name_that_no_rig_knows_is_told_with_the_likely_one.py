"""A slip of the keyboard costs one look, not a search through a list of sixty names."""

import pytest
from toy_rig import ALONG_X, ALONG_Y

from simpter_hybrid.identification.maps import find_map, find_model
from simpter_hybrid.identification.prepared import left_in
from simpter_hybrid.problems import InvalidInput
from simpter_hybrid.reading.reader import one_of


def refused(act, *arguments):
    with pytest.raises(InvalidInput) as caught:
        act(*arguments)
    return str(caught.value)


def test_an_effect_to_leave_out():
    assert "did you mean along x?" in refused(left_in, (ALONG_X, ALONG_Y), ["along z", "alongx"])


def test_a_shipped_model():
    assert "did you mean emps?" in refused(find_model, "empss")


def test_a_folder_in_place_of_a_map(tmp_path):
    assert "not a file" in refused(find_map, str(tmp_path), "data.csv", find_model("emps"))


def test_all_that_are_as_near_are_asked():
    assert one_of(["t1", "way", "t2"], "t").endswith("(did you mean t1 or t2?)")
