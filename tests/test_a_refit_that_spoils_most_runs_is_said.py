"""A fit goes by squares: one run that is far off may rule it, and the others are worse then."""

import pytest

from simpter_hybrid.identification.reporting.run_errors import spoilt_sentence


def runs(*errors):
    return [
        {"run": f"run {k}", "declared": a, "refitted": b, "after": b}
        for k, (a, b) in enumerate(errors, 1)
    ]


def test_the_run_that_rules_and_the_worst_are_named():
    told = {"fit": runs((32.0, 86.0), (465.0, 232.0)), "select": runs((25.0, 69.0), (27.0, 77.0))}
    said = spoilt_sentence(told)
    assert said.startswith("The refit makes 3 of 4 runs worse than as declared")
    assert "mostly for the sake of run 2 (465 to 232)" in said


@pytest.mark.parametrize(
    "select",
    [
        ((25.0, 20.0), (27.0, 77.0)),  # half are no worse
        ((25.0, 26.0), (27.0, 28.0)),  # hardly
    ],
)
def test_nothing_is_said_of_others(select):
    assert not spoilt_sentence({"fit": runs((32.0, 36.0), (465.0, 232.0)), "select": runs(*select)})


def test_what_is_near_the_floor_is_not_spoilt():
    fit, select = runs((1.0, 1.4), (4.0, 2.0)), runs((0.9, 1.3), (0.8, 1.2))
    assert spoilt_sentence({"fit": fit, "select": select}) == ""
    far = [{k: v if k == "run" else 9.0 * v for k, v in one.items()} for one in (*fit, *select)]
    assert spoilt_sentence({"fit": far[:2], "select": far[2:]})


def test_no_run_rules_where_none_has_most_of_the_fall():
    told = {"fit": runs((200.0, 100.0), (200.0, 100.0)), "select": runs(*[(25.0, 69.0)] * 3)}
    assert spoilt_sentence(told) == ""


def test_what_an_effect_mends_is_not_spoilt():
    told = {"fit": runs((465.0, 232.0)), "select": runs((25.0, 69.0), (27.0, 77.0))}
    assert spoilt_sentence(told)
    for one in told["select"]:
        one["after"] = 2.0
    assert spoilt_sentence(told) == ""
