"""A kernel whose machine code knows a model's sizes, beside the one that asks for them."""

import numpy as np
import pytest

from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.machine_code import program
from simpter_hybrid.machine_code.program import Program, Room

pytest.importorskip("llvmlite")


def test_to_the_last_digit(monkeypatch):
    scenario = load("testbed-tracking-0.08")
    sized = Program(scenario, sized=True)
    monkeypatch.setattr(program, "is_kept", lambda name: False)
    plain = Program(scenario)
    assert plain.kernel[1] != sized.kernel[1]
    grid = np.linspace(0.0, scenario.t_end, 50)
    one, other = (p.once(Room(2000, 0, 0), grid=grid) for p in (plain, sized))
    assert np.array_equal(one.rows, other.rows)
    assert np.array_equal(one.counts, other.counts)
