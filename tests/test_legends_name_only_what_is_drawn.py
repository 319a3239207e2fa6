"""The start of a run is no mark in a picture, and axes bear the unit of what they show."""

import matplotlib.pyplot as plt
import pytest

import simpter_hybrid as simpter
from simpter_hybrid.clutch import Clutch
from simpter_hybrid.devices.one_axis import LinearAxis
from simpter_hybrid.devices.testbed import Testbed
from simpter_hybrid.laws import LinearTorque
from simpter_hybrid.measuring.sampling import sample
from simpter_hybrid.plots.motion import acceleration
from simpter_hybrid.plots.style import event_handles
from simpter_hybrid.scenario import Scenario


def test_the_start_has_no_entry():
    run = simpter.run(simpter.load("reduced-clutch-1"))
    assert [e.kind for e in run.events] == ["start", "breakaway"]
    assert [handle.get_label() for handle in event_handles(run)] == ["breakaway"]


CLUTCH = Clutch(LinearTorque(1.0))


@pytest.mark.parametrize(("device", "unit"), [(Testbed(1.0), "rad/s²"), (LinearAxis(1.0), "m/s²")])
def test_accelerations_bear_the_unit_of_the_coordinates(device, unit):
    run = simpter.run(Scenario("one", device, (CLUTCH,), (0.0,), (1.0,), 0.1))
    drawn = acceleration(run, sample(run))
    assert drawn.axes[0].get_ylabel() == f"acceleration [{unit}]"
    plt.close(drawn)
