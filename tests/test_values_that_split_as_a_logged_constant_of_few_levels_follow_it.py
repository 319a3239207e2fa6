"""Own values of runs that a logged constant of two or three levels splits: they follow it."""

import pytest

from simpter_hybrid.identification.going_with import goes_with, split_by
from simpter_hybrid.identification.reporting.level_sentences import levels_text
from simpter_hybrid.identification.run_levels import RunLevels


def of(times, payload):
    runs = tuple((f"run {k}", v) for k, v in enumerate(times))
    logged = {"payload": {run: p for (run, _), p in zip(runs, payload, strict=True)}}
    return RunLevels("inertia", runs, 2.0, 1.0, 0.9, logged)


LIGHT, HEAVY = (0.82, 0.83, 0.84, 0.825, 0.835, 0.82), (1.165, 1.16, 1.17, 1.165, 1.16, 1.165)


def mixed(each):
    """Runs with a payload and without it in turn."""
    times = [v for pair in zip(LIGHT[:each], HEAVY[:each], strict=True) for v in pair]
    return of(times, [0.0, 1.0] * each)


def test_of_eight_runs_four_and_four_it_is_told_with_how_often_chance_does_so():
    found = mixed(4)
    assert split_by(found) == {"payload": pytest.approx(2 / 70)}
    said = levels_text([found], floor=1.0)
    assert (
        "it follows payload, which was logged, in all 8 runs (chance does so in 3 of 100)" in said
    )


def test_of_twelve_runs_six_and_six_it_is_sure():
    found = mixed(6)
    assert goes_with(found) == {"payload": 1.0}
    said = levels_text([found], floor=1.0)
    assert "it follows payload, which was logged, in all 12 runs)" in said


def test_a_load_that_was_put_on_once_is_told_and_no_unknown_event():
    said = levels_text([of(LIGHT[:4] + HEAVY[:4], [0.0] * 4 + [1.0] * 4)], floor=1.0)
    assert "follows payload" in said
    assert "changes once" not in said


@pytest.mark.parametrize(
    ("times", "payload"),
    [
        (
            (0.82, 1.16, 0.83, 1.17, 0.82, 1.16, 1.17, 0.83),
            (0, 1, 0, 1, 0, 1, 0, 1),
        ),  # 2 off
        ((0.8, 1.0, 0.85, 1.05, 0.9, 1.1, 0.95, 1.15), (0, 1, 0, 1, 0, 1, 0, 1)),  # evenly spread
        ((0.82, 0.83, 1.16, 1.17), (0, 0, 1, 1)),  # chance does so in one of three
    ],
)
def test_what_is_split_otherwise_or_by_chance_is_not(times, payload):
    found = of(times, payload)
    assert split_by(found) == {}
    assert "payload" not in levels_text([found], floor=1.0)


def test_three_levels_count_the_ways_of_three_groups():
    levels = (0.0, 1.0, 2.0) * 3
    found = of([1.0 + 0.2 * p + 0.002 * k for k, p in enumerate(levels)], levels)
    assert split_by(found) == {"payload": pytest.approx(1 / 280)}
