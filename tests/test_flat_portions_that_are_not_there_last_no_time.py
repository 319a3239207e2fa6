"""The verdict on how long slip velocities rest fails without rests, and with mere instants."""

from dataclasses import replace

import pytest

pytest.importorskip("llvmlite", reason="the standard runs need the compiled engine")

from simpter_hybrid.compiled import simulate
from simpter_hybrid.measuring.transitions import transitions
from simpter_hybrid.reproduce import baseline as rows


@pytest.mark.parametrize(
    ("flat", "verdict"),
    [
        (((), (), (), ()), "does not hold"),
        (((), (), ((0.5, 0.501),), ()), "does not hold"),
        (((), (), ((0.5, 0.52),), ()), "holds"),
    ],
)
def test_it_can_fail(monkeypatch, flat, verdict):
    monkeypatch.setattr(rows, "transitions", lambda run: replace(transitions(run), flat=flat))
    found = rows.baseline(simulate, draws=1)
    (row,) = (r for r in found if r.claim == "the flat portions last a finite time")
    assert row.verdict == verdict
