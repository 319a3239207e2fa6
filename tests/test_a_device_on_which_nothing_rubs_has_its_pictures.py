"""Without surfaces and without a known potential there are no layers of energy to draw."""

from dataclasses import dataclass
from typing import ClassVar

from simpter_hybrid.device import Device
from simpter_hybrid.engine import simulate
from simpter_hybrid.plots import figures
from simpter_hybrid.scenario import Scenario


@dataclass(frozen=True)
class Swing(Device):
    coordinates: ClassVar[tuple[str, ...]] = ("x",)
    surfaces: ClassVar[tuple[str, ...]] = ()

    @staticmethod
    def mass_matrix(q, p, out):
        out[0] = 1.0

    @staticmethod
    def velocity_terms(q, qd, p, out):
        out[0] = 0.0

    @staticmethod
    def clutch_map(q, p, out):
        pass

    @staticmethod
    def clutch_map_rate(q, qd, p, out):
        pass

    @staticmethod
    def conservative_force(q, p, out):
        out[0] = -q[0]


def test_of_its_energy_what_was_put_in():
    run = simulate(Scenario("swing", Swing(), (), (1.0,), (0.0,), 1.0))
    (line,) = figures(run)["energy_budget"].axes[0].lines
    assert line.get_label() == "put in"
