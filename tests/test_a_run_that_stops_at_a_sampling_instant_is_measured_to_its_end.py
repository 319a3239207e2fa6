"""A sweep's measures where a run stops at an instant of the sampling, or a rounding before it."""

import pytest
from devices_for_tests import always_on

from simpter_hybrid.devices.one_axis import LinearAxis
from simpter_hybrid.loads.ramp import RampOnCoordinate
from simpter_hybrid.scenario import Scenario
from simpter_hybrid.stop import CoordinateLimit
from simpter_hybrid.sweeps.work import Case, Options, compiled_cases, reference_cases


def test_both_engines_measure_the_same():
    # 2 N on 1 kg from rest: 1/4 m after 1/2 s, a multiple of the sampling step.
    run = Scenario(
        "axis", LinearAxis(mass=1.0), (always_on(5.0, 5.0),), (0.0,), (0.0,), 3.0,
        loads=(RampOnCoordinate(base=2.0),), stops=(CoordinateLimit(limit=0.25),),
    )  # fmt: skip
    options = Options("compiled", "brief", 1e-3, "")
    measured = []
    for cases in (reference_cases, compiled_cases):
        record = cases(options, [Case("a", ())], {0: run})[0]
        assert record.status == "stopped"
        assert record.measures["average_acceleration"] == pytest.approx(2.0, rel=1e-12)
        assert record.measures["max_jerk"] == pytest.approx(0.0, abs=1e-6)
        measured.append(record.measures)
    # The end itself differs by rounding.
    assert measured[1] == pytest.approx(measured[0], rel=1e-9, abs=1e-6)
