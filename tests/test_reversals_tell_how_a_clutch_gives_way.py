"""The stiffness and the play that fits of yielding contacts begin from."""

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.rotor.winding import winding

ROW, NOISE, ENCODER = 2e-3, 0.2, 4e-4


def turning(stiffness, gap, friction=15.0, seed=3):
    """A rotor that turns to and fro against a clutch behind a spring with a play; synthetic."""
    random = np.random.default_rng(seed)
    time = np.arange(0.0, 12.0, ROW)
    angle = 0.5 * (1.0 - np.cos(2.0 * np.pi * time / 4.0))
    torque, wound = np.zeros(time.size), 0.0
    reach = friction / stiffness + 0.5 * gap
    for k in range(1, time.size):
        wound = float(np.clip(wound + angle[k] - angle[k - 1], -reach, reach))
        torque[k] = stiffness * np.sign(wound) * max(abs(wound) - 0.5 * gap, 0.0)
    noisy = torque + NOISE * random.normal(size=time.size)
    read = np.round(angle / ENCODER) * ENCODER
    seen = {"clutch_torque": Observation(noisy, NOISE, np.ones(time.size, bool))}
    return Replay("to and fro", "", time, {"command": np.full(time.size, 5.0)}, seen,
                  notes={"position": read})  # fmt: skip


@pytest.mark.parametrize("stiffness", [1e3, 3e3])
@pytest.mark.parametrize("gap", [0.0, 0.01])
def test_both_are_told_as_well_as_the_encoder_tells_them(stiffness, gap):
    found = winding([turning(stiffness, gap)], ENCODER / np.sqrt(12.0))
    assert found is not None
    # A step of the encoder in the way between two torques, and what noise of the torque turns.
    assert found.stiffness == pytest.approx(stiffness, rel=0.15)
    assert found.gap == pytest.approx(gap, abs=2.0 * ENCODER)


def test_a_play_with_hard_ends_is_told_though_its_stiffness_is_not():
    found = winding([turning(1e6, 0.01)], ENCODER / np.sqrt(12.0))
    assert found is not None
    assert found.gap == pytest.approx(0.01, abs=3.0 * ENCODER)


def test_what_does_not_give_tells_nothing():
    assert winding([turning(1e6, 0.0)], ENCODER / np.sqrt(12.0)) is None
