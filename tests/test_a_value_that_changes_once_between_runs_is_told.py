"""A knock, a preload set anew: runs are alike up to one, and alike from another on."""

import pytest

from simpter_hybrid.identification.reporting.level_sentences import levels_text
from simpter_hybrid.identification.run_levels import RunLevels, step_of


def levels(*values):
    runs = tuple((f"run {k + 1}", value) for k, value in enumerate(values))
    return RunLevels("brake", runs, 2.4, 1.3, 0.7)


def test_it_is_told_between_which_runs_and_in_which():
    # Of a spindle that was knocked in its fourth run.
    knocked = levels(0.942, 0.943, 0.932, 1.057, 1.173, 1.173)
    step = step_of(knocked)
    assert (step.until, step.between, step.onwards) == ("run 3", "run 4", "run 5")
    said = levels_text([knocked], 1.0)
    assert "it changes once, in run 4, from 0.939 up to run 3 to 1.173 from run 5 on" in said


def test_a_fall_between_two_runs_is_one_as_well():
    step = step_of(levels(1.2, 1.21, 1.0, 1.0, 1.0))
    assert (step.until, step.between, step.onwards) == ("run 2", "", "run 3")
    assert step.before > step.after


@pytest.mark.parametrize(
    "values",
    [
        (1.0, 1.1, 1.2, 1.3, 1.4, 1.5),  # it rises
        (0.9, 1.1, 0.95, 1.05, 1.0, 0.97),
        (1.0, 1.0, 1.0, 1.3, 1.0, 1.0),  # one is odd
        (0.8, 0.8, 1.2, 1.2),  # of four some are by chance
        (1.0, 1.0, 1.0, 1.001, 1.001, 1.001),  # next to nothing
    ],
)
def test_what_goes_on_or_comes_back_is_none(values):
    assert step_of(levels(*values)) is None
