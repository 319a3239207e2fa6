"""The thesis's eight reduced-order tests: Karnopp against the exact engine."""

from functools import cache
from importlib.util import find_spec

import numpy as np
import pytest

from simpter_hybrid.engine import simulate as exact
from simpter_hybrid.files.scenario_file import load, shipped_scenarios
from simpter_hybrid.karnopp import FAIR, THESIS, Settings
from simpter_hybrid.karnopp.simulate import on_grid, prepare

#: Either way to the same bits, in a tenth of the time.
COMPILED = find_spec("llvmlite") is not None
REDUCED = [name for name in shipped_scenarios() if name.startswith("reduced-clutch")]


@cache
def exact_end(name):
    return exact(load(name)).end


def error(name, band, rules, **settings):
    """Largest error of the final link angles [rad]."""
    usual = {"band": band, "rules": rules, "rtol": 1e-8, "atol": 1e-11, "compiled": COMPILED}
    settings = Settings(**usual | settings)
    found = on_grid(prepare(load(name), settings), [], settings)
    assert found.status == "finished"
    return float(np.abs(found.end - exact_end(name))[:2].max())


@pytest.mark.parametrize("name", REDUCED)
def test_with_tuned_rules_whatever_the_band(name):
    for band in (1e-1, 1e-3):
        # Breakaway and slip torque are equal: only the solver's tolerance is left.
        assert error(name, band, FAIR) < 2e-8


@pytest.mark.parametrize("name", REDUCED[:2])
def test_with_fixed_steps_as_the_square_of_the_step(name):
    for step in (8e-3, 2e-3, 5e-4):
        # The ramp has 0.4 rad/s^3 at most: a kink in a step costs half of that times its square
        # in speed, for 2.4 s.
        assert error(name, 1e-2, FAIR, solver="fixed", step=step) < 0.5 * 0.4 * step**2 * 2.4


@pytest.mark.parametrize("name", REDUCED)
def test_with_the_thesis_limiter_in_proportion_to_the_band(name):
    errors = [error(name, band, THESIS) for band in (1e-1, 1e-2, 1e-3)]
    # A link slower than the band does not move: its displacement is missing.
    assert errors[0] > 5.0 * errors[1] > 25.0 * errors[2]
    assert errors[2] < 5e-4
