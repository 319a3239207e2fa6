"""A pendulum's drag fell with its amplitude; it was told as something that happened in between."""

import pytest

from simpter_hybrid.identification.levels_with_speed import goes_with_speed
from simpter_hybrid.identification.reporting.level_sentences import levels_text
from simpter_hybrid.identification.run_levels import RunLevels

SAID = "with how fast a run moves"


def levels(values, speeds):
    runs = [f"run {k}" for k in range(len(values))]
    told, moved = zip(runs, values, strict=True), dict(zip(runs, speeds, strict=False))
    return RunLevels("drag", tuple(told), 2.4, 1.3, 0.7, speeds=moved)


def test_it_is_told_beside_a_step():
    swings = levels((1.38, 1.32, 1.0, 0.35, 0.48), (0.60, 0.55, 0.35, 0.24, 0.23))
    said = levels_text([swings], 1.0)
    assert "changes once" in said
    assert f"rises {SAID} (chance does so in 8 of 100)" in said


def test_what_falls_is_told_to_fall():
    found = goes_with_speed(levels((1.3, 1.1, 0.9, 0.7), (1.0, 2.0, 3.0, 4.0)))
    assert found.tau == -1.0
    assert found.chance == pytest.approx(2.0 / 24.0)  # two of all orders of four


@pytest.mark.parametrize(
    ("values", "speeds"),
    [
        ((1.3, 0.7, 1.1, 0.9), (1.0, 2.0, 3.0, 4.0)),
        ((1.3, 1.1, 0.7), (1.0, 2.0, 3.0)),  # of three many do by chance
        ((1.3, 1.1, 0.9, 0.7), (1.0, 2.0)),  # not known of all
        ((1.3, 1.1, 0.9, 0.7), (2.0, 2.01, 2.02, 2.03)),  # all as fast
    ],
)
def test_other_values_are_not(values, speeds):
    assert SAID not in levels_text([levels(values, speeds)], 1.0)


@pytest.mark.parametrize(("last", "told"), [(0.53, True), (0.9, False)])
def test_of_pieces_of_two_runs_it_is_told_if_it_holds_in_each(last, told):
    """Two roads of other friction: over all pieces the rank correlation is 0.73."""
    values, speeds = (1.79, 1.16, 0.98, 1.02, 0.83, last), (27.0, 18.4, 5.8, 19.0, 8.0, 4.4)
    runs = [f"file {road}, piece {k}" for road in "ab" for k in (1, 2, 4)]
    pieces = tuple(zip(runs, values, strict=True))
    moved = dict(zip(runs, speeds, strict=True))
    said = levels_text([RunLevels("drag", pieces, 2.4, 1.3, 0.7, speeds=moved)], 1.0)
    # Two of the 36 orders of three and three.
    words = "rises with how fast a piece moves among the pieces of each run (chance does so in 6 of"
    assert (words in said) is told


def test_beside_runs_of_one_piece_nothing_is_told_of_pieces():
    """Four pieces of one run rise with their speed; six other runs fall with theirs."""
    runs = [f"a, piece {k}" for k in range(1, 5)] + [f"{road}, piece 1" for road in "bcdefg"]
    values = (1.0, 1.1, 1.2, 1.3, 2.0, 1.8, 1.6, 1.4, 1.2, 0.9)
    moved = dict(zip(runs, (1.0, 2.0, 3.0, 4.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0), strict=True))
    pieces = tuple(zip(runs, values, strict=True))
    assert goes_with_speed(RunLevels("drag", pieces, 2.4, 1.3, 0.7, speeds=moved)) is None
    one = RunLevels("drag", pieces[:4], 2.4, 1.3, 0.7, speeds=moved)
    assert goes_with_speed(one).tau == 1.0
