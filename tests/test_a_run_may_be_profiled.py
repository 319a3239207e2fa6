"""The check of a start looks into functions by a profile hook and leaves a profiler as it was."""

import cProfile
import pstats
import sys

from simpter_hybrid import load


def test_a_scenario_loads_under_a_profiler_that_goes_on():
    profiler = cProfile.Profile()
    profiler.enable()
    load("line-y24")
    assert sys.getprofile() is profiler
    profiler.disable()
    assert pstats.Stats(profiler).total_calls > 100
