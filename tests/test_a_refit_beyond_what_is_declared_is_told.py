"""Declared numbers that moved far are named."""

import pytest
from refitted import MASS, found

from simpter_hybrid.identification.fitting.predictor import Parameter
from simpter_hybrid.identification.reporting.refits import refit_sentence, traded_sentence


@pytest.mark.parametrize(("mass", "friction"), [(1.04, 0.81), (0.96, 1.19), (1.0, 1.0)])
def test_what_stays_within_its_tolerance_is_not_told(mass, friction):
    assert refit_sentence(found(mass, friction)) == ""


def test_what_goes_beyond_it_and_not_far_is_told_apart():
    said = refit_sentence(found(0.88, 1.39))
    usual, _, beyond = said.partition(" Refitted beyond its tolerance: ")
    assert "mass" in usual
    assert beyond == "friction +39.0 % (declared to 20 %)."


def test_what_is_told_of_it_is_beyond_what_is_told_of_its_tolerance():
    assert refit_sentence(found(1.0, 1.2003)) == ""  # +20.0 % is declared to 20 %
    assert "friction +20.1 % (declared to 20 %)" in refit_sentence(found(1.0, 1.2006))
    sharp = Parameter("friction", 1.0, 0.9, 1.1, 0.01, tolerance=3e-4)
    moved = found(1.0, 1.0004)
    moved.search.corrected.predictor.parameters = (MASS, sharp)
    assert "friction +0.040 % (declared to 0.03 %)" in refit_sentence(moved)


def test_what_moved_farther_is_told_with_what_was_declared():
    said = refit_sentence(found(0.88, 1.1))
    assert "mass -12.0 % (declared to 5 %)" in said
    assert "friction" not in said
    assert "sensor" not in said


def test_what_fell_to_a_part_of_itself_is_told_though_it_is_no_two_tolerances():
    half = Parameter("friction", 1.0, 0.01, 9.0, 0.01, tolerance=0.5)
    fallen = found(1.0, 0.05)
    fallen.search.corrected.predictor.parameters = (MASS, half)
    assert "friction -95.0 % (declared to 50 %)" in refit_sentence(fallen)
    fallen.search.corrected.values["friction"] = 0.3
    assert "far beyond" not in refit_sentence(fallen)


def test_what_ended_as_far_as_is_tried_is_no_estimate():
    said = refit_sentence(found(1.0, 0.5))
    assert "friction -50.0 % (declared to 20 %, and no farther is tried)" in said
    wide = Parameter("friction", 1.0, 0.05, 2.0, 0.01, tolerance=0.7)
    at_its_end = found(1.0, 0.05)
    at_its_end.search.corrected.predictor.parameters = (MASS, wide)
    assert "friction -95.0 % (declared to 70 %, and no farther" in refit_sentence(at_its_end)


def test_what_ended_so_within_its_tolerance_is_not_said_to_be_beyond_it():
    ended = found(1.0, 0.05)
    wide = Parameter("friction", 1.0, 0.05, 2.0, 0.01, tolerance=2.0)
    ended.search.corrected.predictor.parameters = (MASS, wide)
    assert refit_sentence(ended) == (
        "Refitted to the end of what is tried, though within its tolerance: friction -95.0 % "
        "(declared to 200 %, and no farther is tried)."
    )


def test_what_ended_beyond_it_and_not_far_is_told_among_what_did():
    ended = found(1.12, 1.3)
    narrow = Parameter("friction", 1.0, 0.5, 1.3, 0.01, tolerance=0.2)
    ended.search.corrected.predictor.parameters = (MASS, narrow)
    usual, _, beyond = refit_sentence(ended).partition(" Refitted beyond its tolerance: ")
    assert usual == "Refitted far beyond its tolerance: mass +12.0 % (declared to 5 %)."
    assert beyond == "friction +30.0 % (declared to 20 %, and no farther is tried)."


@pytest.mark.parametrize(
    ("correlation", "beside", "told"),
    [(0.999, "friction", True), (-0.999, "friction", True), (0.9, "friction", False),
     (0.999, "drag.coefficient", False)],
)  # fmt: skip
def test_a_declared_number_that_is_known_with_it_alone_is_told(correlation, beside, told):
    rows = [
        {"name": one, "largest_correlation": correlation, "with": other}
        for one, other in (("mass", beside), (beside, "mass"))
    ]
    said = traded_sentence(found(1.12, 1.05), rows)
    assert bool(said) == told
    assert not told or "mass and friction only together" in said
    assert traded_sentence(found(1.0, 1.05), rows) == ""  # nothing was refitted far
