"""An effect that follows a logged channel has its course in every run, and else its own points."""

import numpy as np
import pytest

from simpter_hybrid.effects.by_temperature import FrictionByTemperature
from simpter_hybrid.effects.drift import Drift
from simpter_hybrid.identification.fitting.replay import Replay
from simpter_hybrid.identification.rigs.following import POINTS, following, with_room
from simpter_hybrid.interpolation import hermite_value

TIME = np.linspace(0.0, 10.0, 2001)
OWN = ((0.0, 290.0), (2.0, 300.0), (3.0, 295.0))


def _course(logged=None, setting=None) -> np.ndarray:
    """The temperature at `TIME` of an effect that is the second of a scenario."""
    effects = with_room([Drift(clutch=0), FrictionByTemperature(clutch=0, points=OWN)])
    table = np.array(effects[1].table())
    names = {"effect.2.FrictionByTemperature.table.0": 5}
    given = np.concatenate([np.zeros(5), table])
    run = Replay("run", "run", TIME, {}, {}, logged=logged or {}, setting=setting or {})
    told = following(given, names, effects, run)
    assert not told[:5].any()
    return np.array([hermite_value(told, 6, int(told[5]), 3, 1, t) for t in TIME])


def test_without_a_channel_it_has_its_own_points():
    own = np.array(FrictionByTemperature(clutch=0, points=OWN).table())
    kept = [hermite_value(own, 1, int(own[0]), 3, 1, t) for t in TIME]
    np.testing.assert_allclose(_course(), kept, rtol=1e-14)
    np.testing.assert_allclose(_course(logged={"humidity": TIME}), kept, rtol=1e-14)


def test_a_logged_course_is_followed_and_its_noise_is_not():
    noise = np.random.default_rng(1).normal(0.0, 0.5, TIME.size)
    slow = 300.0 + 5.0 * np.sin(0.5 * TIME)
    left = _course(logged={"temperature": slow + noise}) - slow
    # Some forty rows for each point: noise is left by 0.5/6, and by half a point at the ends.
    assert np.std(left) < 0.5 / np.sqrt(TIME.size / POINTS) * 1.5
    assert np.abs(left).max() < 0.5


def test_a_constant_of_the_run_is_its_temperature():
    assert _course(setting={"temperature": 311.0}) == pytest.approx(311.0, rel=1e-14)
