"""Runs that fit and those that select ask of it, and every unit that is doubted does."""

from simpter_hybrid.identification import doubted_channels
from simpter_hybrid.identification.doubted_channels import Doubt, with_numbers
from simpter_hybrid.identification.map_changes import Times
from simpter_hybrid.identification.numbers_instead import NumberInstead
from simpter_hybrid.identification.reporting.doubted_sentence import doubted_sentence

MASS, LIGHTER = NumberInstead("device.mass", 10.1, 0.15), NumberInstead("device.mass", 9.8, 0.004)
DRIVE = NumberInstead("load.1.constant", 0.1, 0.3)
FORCE, POSITION = Times(("force",), 10.0), Times(("position",), 0.1)


def test_the_best_of_its_sizes_is_told_and_another_number_beside_it():
    doubts = Doubt(FORCE, 0.2, "fit", (MASS, DRIVE)), Doubt(POSITION, 0.21, "select", (LIGHTER,))
    said = doubted_sentence(doubts)
    assert "With device.mass 9.8 times as declared only 0.4 % of the refitted model's error" in said
    assert "10.1 times" not in said
    assert "load.1.constant 0.1 times as declared 30 %" in said


def test_it_is_fitted_once_for_all_units_that_the_same_runs_doubt(monkeypatch):
    asked = []

    def fitted(predictor, values, runs, replays, most):
        asked.append((replays, most))
        return tuple(n for n in (MASS, DRIVE) if n.left <= most)

    monkeypatch.setattr(doubted_channels, "numbers_instead", fitted)
    doubts = [Doubt(POSITION, 0.1), Doubt(FORCE, 0.2), Doubt(POSITION, 0.2, "fit")]
    runs = {"select": ["one"], "fit": ["other"]}
    near, far, other = with_numbers(doubts, None, {}, [], runs)
    assert sorted(asked) == [(["one"], 0.4), (["other"], 0.4)]
    assert near.numbers == (MASS,)  # no more than twice what its unit leaves
    assert far.numbers == other.numbers == (MASS, DRIVE)


def test_it_is_called_as_its_tolerance_with_its_place_in_the_file():
    said = DRIVE._replace(tolerance="motor constant").said
    assert said == "motor constant (load.1.constant) 0.1 times as declared"
    assert DRIVE._replace(tolerance="load.1.constant").said == DRIVE.said
