"""``simpter diagnose --without``: all forms of an effect go, and a wrong name is refused."""

import pytest

from simpter_hybrid.identification.prepared import left_in
from simpter_hybrid.identification.rotor.candidates import rotor_candidates
from simpter_hybrid.problems import InvalidInput


def test_all_its_forms_are_left_out():
    kept = {c.name for c in left_in(rotor_candidates(), ["stribeck"])}
    assert not kept & {"stribeck", "logarithmic-speed", "degressive-speed"}
    assert "asymmetry" in kept


def test_every_wrong_name_is_told_with_the_right_ones():
    with pytest.raises(InvalidInput) as error:
        left_in(rotor_candidates(), ["stribek", "heat"])
    assert [p.value for p in error.value.problems] == ["stribek", "heat"]
    assert "stribeck" in error.value.problems[0].right
