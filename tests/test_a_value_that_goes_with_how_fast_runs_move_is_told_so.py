"""A pendulum's drag fell with its amplitude; it was told as something that happened in between."""

import pytest

from simpter_hybrid.identification.reporting.level_sentences import levels_text
from simpter_hybrid.identification.run_levels import RunLevels, goes_with_speed

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
