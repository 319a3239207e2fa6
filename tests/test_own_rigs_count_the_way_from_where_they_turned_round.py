"""More friction after a reversal, in generators of recordings: a stop in between changes nothing.

With dry friction a motion nearly always stops before it turns round.
"""

import importlib
import sys
from pathlib import Path

import numpy as np
import pytest

BENCHMARKS = str(Path(__file__).resolve().parent.parent / "benchmarks")
NAMES = ("own_axis_files", "own_motor", "own_one_axis", "own_testbed_physics")
#: More friction there, as a part of it.
MORE = 0.4


@pytest.fixture
def bench(monkeypatch):
    """The modules in plain Python: to compile them takes longer than these short runs."""
    monkeypatch.setitem(sys.modules, "numba", None)
    monkeypatch.syspath_prepend(BENCHMARKS)
    for name in NAMES:
        monkeypatch.delitem(sys.modules, name, raising=False)
    yield {name: importlib.import_module(name) for name in NAMES}
    for name in NAMES:
        sys.modules.pop(name, None)


def slid(bench, *pushes):
    """Places where it stands after pushes of 0.1 s, as parts of the friction, and 0.4 s of rest."""
    files = bench["own_axis_files"]
    count = round(0.1 / files.STEP)
    force = np.repeat([f * files.COULOMB for push in pushes for f in (push, *4 * (0.0,))], count)
    hidden = dict.fromkeys(files.ORDER, 0.0) | {"ages": MORE}
    rows = files.slide(force, count, False, *(hidden[name] for name in files.ORDER))
    return rows[4::5, 0]


def test_a_slide_that_stopped_is_held_by_more_where_it_turns_round(bench):
    places = slid(bench, 3.0, -1.2, -1.6)
    assert places[1] == places[0] > 0.01  # 1.2 is less than 1.4
    assert places[2] < places[1]


def test_a_slide_that_goes_on_is_not(bench):
    places = slid(bench, 3.0, 1.2)
    assert places[1] > places[0] > 0.01  # of 0.4 less than 0.15 are left


def test_a_motor_that_stopped_is_held_by_more_where_it_turns_round(bench):
    motor = bench["own_motor"]
    rows = round(0.5 / motor.ROW)
    held = motor.COULOMB * motor.R / motor.K / motor.SUPPLY  # duty that just turns it

    def turned(back):
        # No cogging, no lag; it spins up, stands and is told to turn back.
        duty = np.repeat([2.0 * held, 0.0, back * held], rows)
        return motor.turned(duty, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, MORE, 0.0)[:, 0]

    angle = turned(-1.2)
    assert angle[-1] == angle[2 * rows] > 1.0
    assert turned(-1.6)[-1] < angle[-1]
