"""A device with a table beyond its parameters can be asked for its arrays outside a run too."""

from dataclasses import dataclass, replace

import numpy as np
from axis_recordings import declared_axis

from simpter_hybrid.devices.one_axis import OneAxis
from simpter_hybrid.identification.axis.prescribed_rig import inertia
from simpter_hybrid.identification.rigs.pose import clutch_maps, inertia_of
from simpter_hybrid.identification.rigs.scenario_runner import ScenarioRunner
from simpter_hybrid.measuring.over_poses import over_poses


@dataclass(frozen=True)
class Tabled(OneAxis):
    """Its clutch turns by its table's first number, its inertia is by the second.

    The table is behind the five parameters.
    """

    constant_clutch_map = False

    def table(self):
        return 3.0, 0.05

    @staticmethod
    def mass_matrix(q, p, out):
        out[0] = p[6] * (1.0 + q[0])

    @staticmethod
    def clutch_map(q, p, out):
        out[0] = p[5]


MADE = replace(declared_axis(), device=Tabled(inertia=1.0))
POSES = np.array([0.0, 1.0])


def test_in_every_pose():
    found = over_poses(MADE.device, "mass_matrix", POSES[:, np.newaxis], 1)
    np.testing.assert_allclose(found, [[0.05], [0.1]], rtol=1e-15)


def test_of_a_declared_model():
    assert inertia_of(MADE) == 0.05
    np.testing.assert_array_equal(clutch_maps(MADE, POSES[:, np.newaxis]), [[[3.0]], [[3.0]]])


def test_of_a_fitted_one():
    runner = ScenarioRunner(MADE)
    fitted = runner.default.copy()
    fitted[runner.names["device.table.1"]] *= 2.0
    np.testing.assert_allclose(inertia(runner, fitted, POSES), [0.1, 0.2], rtol=1e-15)
