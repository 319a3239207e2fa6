"""Errors of angles are told in rad and those of lengths in m, in words and pictures."""

import pytest
from devices_for_tests import Ramp, always_on

from simpter_hybrid.comparison import compare, karnopp
from simpter_hybrid.comparison.bounds import exceeded
from simpter_hybrid.devices.one_axis import LinearAxis, OneAxis
from simpter_hybrid.plots.comparison import error_against_band
from simpter_hybrid.scenario import Scenario


@pytest.mark.parametrize(("device", "way"), [(OneAxis(2.0), "rad"), (LinearAxis(2.0), "m")])
def test_a_comparison_has_the_units_of_its_device(device, way):
    push = Ramp(0.0, ((0.0, 0.0), (3.0, 3.0)))
    scenario = Scenario(
        "ramp", device, (always_on(1.0, 1.3),), (0.0,), (0.0,), 3.0, loads=(push,),
        command=(1.0,), excitation=(1.0,),
    )  # fmt: skip
    found = compare(scenario, [karnopp(1e-1)])
    bounds = dict.fromkeys(("final_error", "path_error", "drift"), 1e-12)
    assert [str(b).split()[-1] for b in exceeded(found, bounds)] == [way] * 3
    left = error_against_band(found).axes[0]
    assert left.get_xlabel() == f"band or width [{way}/s]"
    assert left.get_ylabel().endswith(f"[{way}]")
