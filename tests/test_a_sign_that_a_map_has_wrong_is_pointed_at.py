"""Speeds against the positions beside them, sensors against the model."""

from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.identification.recording_agreement import disagreements
from simpter_hybrid.identification.replay import Observation, Replay
from simpter_hybrid.identification.reversed_channels import better_reversed

TIME = np.linspace(0.0, 4.0, 801)
ANGLE = np.sin(2.0 * TIME)
RATE = 2.0 * np.cos(2.0 * TIME)


def _said(angle, rate, role="measured"):
    channels = {"position_1": angle, "speed_1": rate}
    described = {name: SimpleNamespace(role=role) for name in channels}
    return list(disagreements([(TIME, channels)], described))


@pytest.mark.parametrize(
    ("factor", "word"), [(-1.0, "sign"), (-0.1, "sign"), (0.105, "unit"), (9.55, "unit")]
)
def test_a_speed_is_the_rate_of_its_position(factor, word):
    (found,) = _said(ANGLE, RATE / factor)
    assert word in found.right
    # Integrated by trapezoids of 5 ms: a part of 1e-5.
    assert found.factor == pytest.approx(factor, rel=1e-4)
    assert not _said(ANGLE, RATE / factor, role="constant")


def test_a_sensor_that_is_off_by_less_is_left_to_the_diagnosis():
    noise = np.random.default_rng(3).normal(0.0, 0.02, TIME.size)
    assert not _said(ANGLE, 1.4 * RATE)
    assert not _said(ANGLE + noise, RATE)
    assert not _said(noise, noise[::-1])  # nothing moved: nothing can be said
    assert not _said(np.full(TIME.size, np.nan), RATE)


class _Brake:
    """Friction of 1 N against the speed."""

    parameters = ()

    def predict(self, values, replays):
        return {"force": [-np.sign(r.inputs["speed"]) for r in replays]}


@pytest.mark.parametrize(("sign", "doubted"), [(1.0, []), (-1.0, ["speed", "force"])])
def test_a_channel_that_fits_turned_round_is_doubted(sign, doubted):
    noise = np.random.default_rng(4).normal(0.0, 0.1, TIME.size)
    force = Observation(-sign * np.sign(RATE) + noise, 0.1, np.ones(TIME.size, bool))
    inputs = {"speed": RATE, "command": np.ones(TIME.size)}
    found = better_reversed(_Brake(), {}, [Replay("r", "e", TIME, inputs, {"force": force})])
    assert list(found) == doubted
    assert all(left < 0.1 for left in found.values())
