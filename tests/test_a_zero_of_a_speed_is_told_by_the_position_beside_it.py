"""A speed that is off by the same in all runs; and all that could be taken for that."""

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.agreement import gains_apart
from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.speed_zero import (
    less_zeros,
    speed_zeros,
    zero_remarks,
)

TIME = 0.004 * np.arange(1000)
SPEED = ChannelMap("speed", "w", "rad/s", "measured")
CHANNELS = {"position": ChannelMap("position", "q", "rad", "measured"), "speed": SPEED}


def runs(zero=0.0, gain=1.0, noise=0.01, late=0, count=4, means=(0.3, 0.9, 0.0, 1.4)):
    """Runs at their mean speeds, and about them; `zero` of each, or of all."""
    random, made = np.random.default_rng(3), []
    for k, off in zip(range(count), np.broadcast_to(zero, count), strict=True):
        speed = means[k] + 0.2 * np.sin((2.0 + k) * TIME)
        angle = means[k] * TIME - 0.2 / (2.0 + k) * np.cos((2.0 + k) * TIME)
        seen = gain * np.concatenate([np.full(late, speed[0]), speed[: TIME.size - late]]) + off
        seen = seen + noise * random.standard_normal(TIME.size)
        made.append((TIME, {"position": angle, "speed": seen}))
    return made


@pytest.mark.parametrize(
    ("zero", "others"), [(0.05, {}), (-0.05, {}), (0.05, {"gain": 1.03}), (-0.05, {"late": 2})]
)
def test_its_size_is_told_whatever_else_is_off(zero, others):
    (found,) = speed_zeros(runs(zero, **others), CHANNELS)
    # Noise of 0.01 rad/s in 4000 rows, and a gain that is told beside it.
    assert found.zero == pytest.approx(zero, abs=2e-3)
    assert list(speed_zeros(less_zeros(runs(zero, **others), [found]), CHANNELS)) == []


@pytest.mark.parametrize(
    "made",
    [
        runs(),
        runs(gain=1.03),
        runs(late=3),
        runs(0.002),
        runs((0.05, 0.05, 0.05, -0.01)),
        runs(0.05, count=2),
        runs(0.02, noise=0.2),
        runs(gain=1.03, means=(1.0, 1.0, 1.0, 1.0), noise=0.0),
    ],
    ids=["right", "gain", "late", "small", "another in one run", "few runs", "noise", "one speed"],
)
def test_nothing_else_is(made):
    assert list(speed_zeros(made, CHANNELS)) == []


def test_a_gain_is_asked_about_without_it():
    forward = runs(0.05, means=(0.1, 0.2, 0.3, 0.2), noise=0.001)
    assert gains_apart(forward, CHANNELS)
    found = list(speed_zeros(forward, CHANNELS))
    assert not gains_apart(less_zeros(forward, found), CHANNELS)


@pytest.mark.parametrize(
    ("sign", "offset", "said"), [(1, 0.0, "-0.05"), (-1, 0.0, "0.05"), (1, 0.02, "-0.03")]
)
def test_what_to_write_in_the_map_is_told(sign, offset, said):
    told = ChannelMap("speed", "w", "rad/s", "measured", 1.0, offset, sign)
    (remark,) = zero_remarks(
        list(speed_zeros(runs(0.05, noise=0.001), CHANNELS)), CHANNELS | {"speed": told}
    )
    assert f'`offset = "{said} rad/s"`' in remark.right
