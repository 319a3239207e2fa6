"""There one linear step tells little of what a candidate can do."""

from types import SimpleNamespace as Some

import pytest

from simpter_hybrid.identification.fitting.survey import followed_far_off, worth_fitting


def probe(name: str, gain: float) -> Some:
    candidate = Some(name=name, coordinates=(), plain="")
    return Some(candidate=candidate, gain=gain)


PROBES = [probe(f"mimic {k}", 0.6 - 0.01 * k) for k in range(5)] + [probe("right", 0.04)]


@pytest.mark.parametrize("blind", [True, False])
def test_one_that_promises_a_fifteenth_of_the_best_is_fitted_where_a_step_tells_little(
    blind: bool,
) -> None:
    fitted = [p.candidate.name for p in worth_fitting(PROBES, (), blind)]
    assert ("right" in fitted) is blind


@pytest.mark.parametrize(
    ("error", "followed", "told"),
    [(50.0, ("whole",), True), (1.5, ("whole",), False), (50.0, (), False)],
)
def test_a_step_tells_little_far_off_runs_that_are_followed(error, followed, told) -> None:
    assert followed_far_off(Some(select_error=error), [Some(followed=followed)], 1.0) is told
