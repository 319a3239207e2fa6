"""Whatever a part raises, the exact engine and both models of comparison keep what there was."""

import math
from dataclasses import dataclass

import pytest
from devices_for_tests import Block, always_on

from simpter_hybrid.applied_load import Load
from simpter_hybrid.comparison import compare, karnopp, regularised
from simpter_hybrid.engine import simulate as exact
from simpter_hybrid.karnopp import simulate as banded
from simpter_hybrid.regularised import simulate as smooth
from simpter_hybrid.scenario import Scenario


@dataclass(frozen=True)
class Edge(Load):
    """A force that is known up to an edge only."""

    edge: float

    @staticmethod
    def force(q, edge, Q):
        if q[0] > edge:
            raise RuntimeError("beyond the edge")
        Q[0] += 1e-9 * math.sqrt(q[0] + 1.0)


def run_of(speed):
    """It would stop of itself after 0.125 m at 0.5 m/s."""
    on = {"command": (1.0,), "excitation": (1.0,), "loads": (Edge(0.13),)}
    return Scenario("edge", Block(), (always_on(1.0, 1.0),), (0.0,), (speed,), 1.0, **on)


@pytest.mark.parametrize("engine", [exact, banded, smooth])
def test_the_run_has_failed_and_names_the_part(engine):
    found = engine(run_of(2.0))
    assert found.status == "failed"
    assert "load 1, force failed (RuntimeError: beyond the edge)" in found.message
    assert 0.0 < found.t_end < 0.07
    assert found.message.startswith(f"after t = {found.t_end!r} s")


def test_a_comparison_keeps_the_other_candidates():
    """Smooth friction creeps on over the edge, a narrow band does not."""
    found = compare(run_of(0.5), [karnopp(1e-3), regularised(0.1), karnopp(1e-2)])
    assert [row.status for row in found.rows] == ["finished", "failed", "finished"]


def test_an_exception_of_no_part_is_not_hidden(monkeypatch):
    def broken(*_):
        raise RuntimeError("a fault of ours")

    monkeypatch.setattr("simpter_hybrid.engine.switch", broken)
    with pytest.raises(RuntimeError, match="a fault of ours"):
        exact(run_of(0.5))
