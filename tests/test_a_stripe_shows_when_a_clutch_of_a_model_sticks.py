"""Modes of a run's segments, at the instants of a record."""

import numpy as np
from matplotlib.figure import Figure

from simpter_hybrid.kernel.records import FORWARD, FREE, STICK
from simpter_hybrid.plots.sticking import stripes, stuck_at

TIME = np.arange(7) * 1.0
SPANS = np.array([[0.0, 1.5], [1.5, 3.0], [3.0, 3.0], [3.0, 5.0]])
MODES = np.array([[STICK, FREE], [FORWARD, STICK], [FORWARD, STICK], [STICK, STICK]])


def test_each_clutch_sticks_when_its_mode_says_so_and_never_after_the_end():
    first, second = stuck_at(TIME, SPANS, MODES).T
    assert first.tolist() == [True, True, False, False, True, True, False]
    assert second.tolist() == [False, False, True, True, True, True, False]


def test_a_run_that_never_began_sticks_nowhere():
    assert not stuck_at(TIME, SPANS[:0], MODES[:0]).any()


def test_several_clutches_have_a_named_stripe_each():
    ax = Figure().add_subplot()
    stuck = dict(zip(("upper", "lower"), stuck_at(TIME, SPANS, MODES).T, strict=True))
    stripes(ax, TIME, stuck, "stuck")
    assert [text.get_text() for text in ax.texts] == ["lower", "upper"]
    assert len(ax.collections) == 2
    assert len(ax.get_legend_handles_labels()[0]) == 1


def test_one_clutch_that_never_sticks_has_none():
    ax = Figure().add_subplot()
    stripes(ax, TIME, {"only": np.zeros(TIME.size, bool)}, "stuck")
    assert not ax.collections
