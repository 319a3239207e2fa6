"""What goes by time in runs let go from one place may go by how far they swing."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.replay import Replay
from simpter_hybrid.identification.reporting.dying_out import dying_out_sentence

TIME = np.linspace(0.0, 7.0, 700)


def _let_go(speed, rate):
    """A run in two pieces."""
    moves = speed * np.exp(-rate * TIME) * np.sin(3.8 * TIME)
    first = Replay("run", "run", TIME[:300], {}, {}, notes={"speed": moves[:300]})
    notes, rest = {"speed": moves[300:]}, TIME[300:] - TIME[300]
    return Replay("piece", "run", rest, {}, {}, notes=notes, stamp=TIME[300], before=first)


def _found(coordinate, *sizes, rate=0.5):
    """A diagnosis of runs let go so that they swing at these speeds, at 0.6 Hz."""
    runs = [replace(_let_go(v, rate), name=f"run {k}") for k, v in enumerate(sizes)]
    runs = [replace(r, before=replace(r.before, name=f"first of {r.name}")) for r in runs]
    verdict = SimpleNamespace(coordinates=(coordinate,), kind="unknown")
    done = SimpleNamespace(verdict=verdict, corrected=SimpleNamespace(effects=()))
    return SimpleNamespace(search=done, split=SimpleNamespace(fit=runs, select=[]))


@pytest.mark.parametrize("sizes", [(1.0,), (1.0, 1.1)])
def test_let_go_from_one_place(sizes):
    said = dying_out_sentence(_found("force:time", *sizes))
    assert "go by time does so, or by how far or how fast it swings" in said


@pytest.mark.parametrize(
    "found",
    [
        _found("force:time", 1.0, 0.2),
        _found("force:time", 1.0, rate=0.0),
        _found("force:position", 1.0),
    ],
    ids=["let go from two places", "swings on", "goes by the place"],
)
def test_where_it_is_told_nothing_is_said(found):
    assert dying_out_sentence(found) == ""


@pytest.mark.parametrize("other", [0.0, 1e-3])
def test_a_joint_at_rest_beside_it_tells_nothing(other):
    found = _found("force:time", 1.0)
    noise = other * np.random.default_rng(0).normal(size=TIME.size)

    def with_rest(run, rows):
        notes = {"speed_1": run.notes["speed"], "speed_2": noise[rows]}
        return replace(run, notes=notes)

    found.split.fit = [
        replace(with_rest(r, slice(300, None)), before=with_rest(r.before, slice(300)))
        for r in found.split.fit
    ]
    assert "how fast it swings" in dying_out_sentence(found)
