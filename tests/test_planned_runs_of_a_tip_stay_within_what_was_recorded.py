"""Experiments planned for a device with a tip: motions, commands, forces and speeds in reach."""

import numpy as np
import pytest

from simpter_hybrid.identification.tip.experiments import TipReach, tip_experiments
from simpter_hybrid.loads.following_hand import gives_way

SLIP = np.array([[1.0, 0.0], [0.0, 1.0], [1.0, -1.0], [1.0, 1.0]])


def _reach(**changes):
    given = {
        "middle": np.array([1.2, 2.0]), "span": np.array([0.4, 0.6]),
        "speed": np.array([0.7, 0.9]), "slip": SLIP, "force": 80.0,
        "commands": np.array([6.0, 7.0, 5.0, 4.0]), "duration": 6.0, "step": 2e-3,
    }  # fmt: skip
    return TipReach(**{**given, **changes})


def test_poses_and_commands_stay_within_the_reach():
    reach = _reach()
    for plan in tip_experiments(reach):
        away = np.abs(plan.pose - reach.middle[:, None])
        assert np.all(away <= reach.span[:, None] * (1 + 1e-12))
        rate = np.quantile(np.abs(np.gradient(plan.pose, reach.step, axis=1)), 0.95, axis=1)
        assert np.all(rate <= reach.speed * (1 + 1e-9))
        assert np.all(plan.commands <= reach.commands[:, None])
        assert np.all(plan.commands >= 0.0)


def test_every_experiment_moves_each_clutch_once_and_runs_alone_but_in_pairs():
    plans = tip_experiments(_reach())
    names = [plan.experiment for plan in plans]
    assert {names.count(name) for name in names} == {4}
    for plan in plans:
        slips = SLIP @ np.ptp(plan.pose, axis=1)
        on = np.count_nonzero(plan.commands.max(axis=1))
        assert on == (0 if "off" in plan.experiment else 2 if "another" in plan.experiment else 1)
        assert np.abs(slips).max() > 0.0


@pytest.mark.parametrize(
    ("commands", "engaged"), [((0.0, 0.0, 5.0, 0.0), {2}), ((0.0,) * 4, set())]
)
def test_a_clutch_that_was_never_on_stays_off(commands, engaged):
    plans = tip_experiments(_reach(commands=np.array(commands)))
    assert len(plans) > 0
    for plan in plans:
        assert set(np.flatnonzero(plan.commands.max(axis=1))) <= engaged


def test_an_arm_is_a_spring_for_small_forces_and_no_stronger_than_its_limit():
    assert gives_way(0.0, 0.0, 20.0) == 1.0
    assert gives_way(3e-3, 4e-3, 20.0) == pytest.approx(1.0, rel=1e-6)
    assert 500.0 * gives_way(300.0, 400.0, 20.0) == pytest.approx(20.0)
