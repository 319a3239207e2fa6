"""Two clutches that are one at first and not later: a run that locked both cannot go on."""

from dataclasses import dataclass

import pytest
from devices_for_tests import Ramp, always_on

from simpter_hybrid.device import Device
from simpter_hybrid.engine import simulate
from simpter_hybrid.scenario import Scenario


@dataclass(frozen=True)
class Wedge(Device):
    """Rows (1, 0) and (1, y): the same at y = 0 only."""

    mass: float = 1.0

    coordinates = ("x", "y")
    surfaces = ("flat", "wedge")
    constant_clutch_map = False

    @staticmethod
    def mass_matrix(q, p, out):
        out[0] = p[0]
        out[1] = 0.0
        out[2] = 0.0
        out[3] = p[0]

    @staticmethod
    def velocity_terms(q, qd, p, out):
        out[0] = 0.0
        out[1] = 0.0

    @staticmethod
    def clutch_map(q, p, out):
        out[0] = 1.0
        out[1] = 0.0
        out[2] = 1.0
        out[3] = q[1]

    @staticmethod
    def clutch_map_rate(q, qd, p, out):
        out[0] = 0.0
        out[1] = qd[1] * qd[1]


def wedged():
    push = Ramp(1.0, ((0.0, 0.5), (9.0, 0.5)))
    run = Scenario("wedge", Wedge(), (always_on(1.0, 1.2),) * 2, (0.0, 0.0), (0.0, 0.0), 1.0)
    return run.replace(loads=(push,), command=(1.0, 1.0), excitation=(1.0, 1.0))


def test_a_lock_that_the_configuration_forbids_fails_with_the_clutch_and_the_reason():
    found = simulate(wedged())
    assert found.status == "failed"
    assert "incompatible locking: clutch 2" in found.message
    assert "let one of them go" in found.message
    # Noticed at the first step's end, not at the segment's.
    assert 0.0 < found.t_end <= 2 * found.scenario.max_step


def test_the_compiled_engine_says_the_same_at_the_same_place():
    pytest.importorskip("llvmlite", reason="the compiled engine needs llvmlite")
    from simpter_hybrid import compiled

    one, other = simulate(wedged()), compiled.simulate(wedged())
    assert other.status == "failed"
    assert "incompatible locking: clutch 2" in other.message
    assert "let one of them go" in other.message
    # Both look at the ends of steps, which two step-size controls place differently.
    assert abs(one.t_end - other.t_end) <= one.scenario.max_step
    assert other.t_end > 0.0
    assert len(other.step_t) <= 3
