"""A stuck set is redundant by the motions it holds, not by how many coordinates a device has."""

from dataclasses import dataclass
from typing import ClassVar

from devices_for_tests import always_on

from simpter_hybrid.comparison.events import redundant_releases
from simpter_hybrid.device import Device
from simpter_hybrid.engine import simulate
from simpter_hybrid.karnopp import TUNED, Settings
from simpter_hybrid.karnopp.simulate import on_grid, prepare
from simpter_hybrid.loads.ramp import RampOnCoordinate
from simpter_hybrid.scenario import Scenario


@dataclass(frozen=True)
class TwoOnOne(Device):
    coordinates: ClassVar[tuple[str, ...]] = ("x", "y")
    coordinate_dimensions: ClassVar[tuple[str, ...]] = ("length", "length")
    surfaces: ClassVar[tuple[str, ...]] = ("first on x", "second on x")

    @staticmethod
    def mass_matrix(q, p, out):
        out[0], out[1], out[2], out[3] = 1.0, 0.0, 0.0, 1.0

    @staticmethod
    def velocity_terms(q, qd, p, out):
        out[0] = out[1] = 0.0

    @staticmethod
    def clutch_map(q, p, out):
        out[0], out[1], out[2], out[3] = 1.0, 0.0, 1.0, 0.0

    @staticmethod
    def clutch_map_rate(q, qd, p, out):
        out[0] = out[1] = 0.0


def test_their_release_is_one():
    run = simulate(Scenario(
        "two", TwoOnOne(), (always_on(1.0, 1.2),) * 2, (0.0, 0.0), (0.0, 0.0), 2.0,
        loads=(RampOnCoordinate(0.0, 2.0),), command=(1.0, 1.0), excitation=(1.0, 1.0),
    ))  # fmt: skip
    ((t, stuck, _),) = redundant_releases(run)
    assert (round(t, 9), stuck) == (1.2, (1, 2))


def test_a_run_without_dense_output_tells_its_releases_too():
    # The map is the same in every pose, so that no state between the ends is asked for.
    scenario = Scenario(
        "two", TwoOnOne(), (always_on(1.0, 1.2),) * 2, (0.0, 0.0), (0.0, 0.0), 2.0,
        loads=(RampOnCoordinate(0.0, 2.0),), command=(1.0, 1.0), excitation=(1.0, 1.0),
    )  # fmt: skip
    settings = Settings(rules=TUNED)
    run = on_grid(prepare(scenario, settings), [], settings)
    assert [stuck for _, stuck, _ in redundant_releases(run)] == [(1, 2)]
