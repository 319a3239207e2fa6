"""A stage in front of others: they get readings, the mechanism keeps its true state."""

from dataclasses import dataclass, replace

import numpy as np
import pytest
from devices_for_tests import Coulomb

from simpter_hybrid.clutch import Clutch
from simpter_hybrid.controller import Controller
from simpter_hybrid.controllers.measurement import Measurement
from simpter_hybrid.devices.testbed import Testbed
from simpter_hybrid.engine import simulate
from simpter_hybrid.noise import gaussian
from simpter_hybrid.scenario import Scenario

PERIOD, SPEED = 0.01, 2.0


@dataclass(frozen=True)
class Reporter(Controller):
    """Holds what it sees, for the test to read."""

    holds = ("seen_q", "seen_qd")

    @staticmethod
    def step(q, qd, held, at_seen_q, at_seen_qd):
        held[at_seen_q] = q[0]
        held[at_seen_qd] = qd[0]


def seen(*stages, engine=simulate):
    run = Scenario("seen", Testbed(1.0), (Clutch(Coulomb(1.0, 1.0)),), (0.3,), (SPEED,), 0.5)
    controllers = tuple((stage, 1) for stage in (*stages, Reporter()))
    found = engine(run.replace(controllers=controllers, period=PERIOD))
    assert found.status == "finished", found.message
    held = [found.held[np.searchsorted(found.segment_t[:, 0], t, "right") - 1, 1:] for t in times()]
    return np.array(held)


def times():
    return np.arange(49) * PERIOD + 0.5 * PERIOD


def true_q():
    return 0.3 + SPEED * np.arange(49) * PERIOD


def test_without_disturbance_the_readings_are_the_state():
    found = seen(Measurement(differenced=0.0))
    assert found[:, 0] == pytest.approx(true_q(), abs=1e-12)
    assert found[:, 1] == pytest.approx(SPEED, abs=1e-12)


def test_noise_and_resolution_are_those_stated():
    found = seen(Measurement(noise=0.02, resolution=0.01, seed=3.0))
    noisy = true_q() + 0.02 * np.array([gaussian(3.0, 0, k) for k in range(49)])
    assert found[:, 0] == pytest.approx(0.01 * np.floor(noisy / 0.01 + 0.5), abs=1e-12)
    assert found[1:, 1] == pytest.approx(np.diff(found[:, 0]) / PERIOD, abs=1e-9)


def test_a_late_reading_is_the_one_before():
    found = seen(Measurement(late=1.0))
    assert found[1:, 0] == pytest.approx(true_q()[:-1], abs=1e-12)


def test_the_speed_between_late_readings_is_as_late():
    stage = Measurement(noise=0.02, seed=3.0, filter=0.02)
    speeds, late = (seen(each)[:, 1] for each in (stage, replace(stage, late=1.0)))
    assert np.array_equal(late[1:], speeds[:-1])


def test_the_same_seed_gives_the_same_bytes():
    stage = Measurement(noise=0.02, resolution=0.01, seed=3.0)
    first = seen(stage)
    assert seen(stage).tobytes() == first.tobytes()
    assert (seen(Measurement(noise=0.02, resolution=0.01, seed=4.0)) != first).any()


@pytest.mark.slow
def test_both_engines_see_the_same_noise():
    pytest.importorskip("llvmlite", reason="the compiled engine needs llvmlite")
    from simpter_hybrid import compiled

    stage = Measurement(noise=0.02, resolution=0.01, seed=3.0)
    found = seen(stage, engine=compiled.simulate)
    # The true angle differs by rounding, the readings then by nothing.
    assert found[:, 0] == pytest.approx(seen(stage)[:, 0], abs=1e-12)


def test_gain_and_offset_are_those_stated():
    found = seen(Measurement(gain=0.1, offset=-0.05))
    assert found[:, 0] == pytest.approx(1.1 * true_q() - 0.05, abs=1e-12)
    assert found[1:, 1] == pytest.approx(1.1 * SPEED, abs=1e-9)
