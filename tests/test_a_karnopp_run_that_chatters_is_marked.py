"""Steps that are cut at every catch and release on the edge of a band are told from others."""

from types import SimpleNamespace

import pytest

from simpter_hybrid.comparison.table import chatter


@pytest.mark.parametrize(
    ("steps", "rejected", "marked"),
    [(50_783, 77_323, True), (5_090, 395, False), (60_000, 9_000, False), (1_000, 1_100, False)],
)
def test_it_rejects_most_of_many_steps(steps, rejected, marked):
    run = SimpleNamespace(statistics={"steps": steps, "rejected_steps": rejected})
    said = chatter(run)
    assert (said is not None) == marked
    if marked:
        assert "77323 of 128106 steps were rejected" in said


def test_other_models_reject_nothing():
    assert chatter(SimpleNamespace(statistics={"steps": 50_000})) is None
