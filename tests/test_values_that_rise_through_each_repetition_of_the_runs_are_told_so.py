"""Friction that wears through a battery of runs and is renewed before the next."""

import pytest

from simpter_hybrid.identification.order_of_kinds import order_of_kinds
from simpter_hybrid.identification.reporting.level_sentences import levels_text
from simpter_hybrid.identification.run_levels import RunLevels

RISING = (0.967, 0.968, 0.985, 1.0, 1.002, 1.019, 1.044, 1.46, 0.96, 1.0, 1.053)
MIXED = (0.926, 0.918, 1.001, 1.012, 0.927, 0.995, 1.0, 1.605, 0.868, 1.775, 1.005)


def levels(values, batteries=3, kind="run"):
    runs = [(f"battery {b}, {kind} {k}", v) for b in range(batteries) for k, v in enumerate(values)]
    return RunLevels("friction", tuple(runs), 2.5, 1.1, 0.96)


@pytest.mark.parametrize("sign", [1, -1])
def test_each_kind_of_run_counts_once(sign):
    found = order_of_kinds(levels([1.0 + sign * (v - 1.0) for v in RISING]))
    assert found.tau == pytest.approx(sign * 0.53, abs=0.02)
    assert found.chance == pytest.approx(0.026, abs=0.005)


def test_it_is_told_with_its_chance():
    said = levels_text([levels(RISING)], 1.0)
    assert "rises on the whole in the order of the runs within each repetition" in said
    assert "chance does so in 3 of 100" in said


@pytest.mark.parametrize(
    "asked",
    [levels(MIXED), levels(RISING, 1), levels(RISING[:4]), levels(RISING, kind="part")],
    ids=["no order", "not repeated", "few", "pieces of a run"],
)
def test_nothing_else_is(asked):
    assert order_of_kinds(asked) is None
