"""A fit goes by squares: one run that is far off may rule it, and the others are worse then."""

import pytest

from simpter_hybrid.identification.reporting.run_errors import spoilt_sentence


def runs(*errors):
    return [{"run": f"run {k}", "declared": a, "refitted": b} for k, (a, b) in enumerate(errors, 1)]


def test_the_run_that_rules_and_the_worst_are_named():
    told = {"fit": runs((32.0, 86.0), (465.0, 232.0)), "select": runs((25.0, 69.0), (27.0, 77.0))}
    said = spoilt_sentence(told)
    assert said.startswith("The refit makes 3 of 4 runs worse than as declared")
    assert "mostly for the sake of run 2 (465 to 232)" in said


@pytest.mark.parametrize(
    "select",
    [
        ((25.0, 20.0), (27.0, 77.0)),  # half are no worse
        ((0.9, 1.2), (0.8, 1.1)),  # all at the floor
    ],
)
def test_nothing_is_said_of_others(select):
    assert not spoilt_sentence({"fit": runs((32.0, 36.0), (465.0, 232.0)), "select": runs(*select)})
