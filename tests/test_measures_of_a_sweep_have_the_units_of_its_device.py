"""A device without a tip is measured along its coordinates, and a slide transmits forces."""

import pytest

from simpter_hybrid.devices.one_axis import LinearAxis, OneAxis
from simpter_hybrid.devices.planar_arm import PlanarArm
from simpter_hybrid.sweeps.case import Record
from simpter_hybrid.sweeps.design import Design
from simpter_hybrid.sweeps.table import Table, table_csv

MEASURED = {"average_jerk": 1.0, "torque_following.1": 2.0}


@pytest.mark.parametrize(
    ("device", "told"),
    [
        (LinearAxis(1.0), ["average_jerk [m/s^3]", "torque_following.1 [N]"]),
        (OneAxis(1.0), ["average_jerk [rad/s^3]", "torque_following.1 [N m]"]),
        (PlanarArm(), ["average_jerk [m/s^3]", "torque_following.1 [N m]"]),
    ],
    ids=["slide", "axis", "arm"],
)
def test_in_the_heads_of_its_table(device, told):
    record = Record("a", {"x": "1"}, "finished", "", 1.0, MEASURED)
    table = Table(Design(("x",), (("1",),)), (record,), device)
    assert table_csv(table).splitlines()[0].split(",")[2:4] == told
