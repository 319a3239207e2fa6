"""A map may say that a force held from row to row: then it steps there, and is not smoothed."""

from dataclasses import replace

import numpy as np
import pytest
import robot_replays as robot

from simpter_hybrid.engine import simulate
from simpter_hybrid.identification.recordings.channel_map import HELD
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.identification.tip.rig import FORCE_HELD, TipRig
from simpter_hybrid.loads.piecewise import PiecewiseTipForce
from simpter_hybrid.measuring.sampling import sample

ROWS = 25
#: So far before each row the force of the reference engine begins to change [s].
STEEP = 1e-9


def _forces():
    """Along x and y, anew every 50 ms [N]."""
    steps = np.arange(robot.TIME.size) // ROWS
    return 40.0 * (-1.0) ** steps, 25.0 * np.cos(2.0 * steps)


def _reference(declared):
    x, y = _forces()
    points = [(0.0, x[0], y[0])]
    for k in range(ROWS, robot.TIME.size, ROWS):
        t = float(robot.TIME[k])
        points += [(t - STEEP, x[k - 1], y[k - 1]), (t, x[k], y[k])]
    begun = (2.0, 2.0, 0.0, 0.0)
    made = replace(
        declared, controllers=(), loads=(PiecewiseTipForce(tuple(points)),), stops=(),
        t_end=float(robot.TIME[-1]), rtol=1e-9, atol=1e-11, command=begun, excitation=begun,
        q=(1.2, 2.0), qd=(0.3, -0.2),
    )  # fmt: skip
    return sample(simulate(made), robot.TIME).q


@pytest.mark.parametrize(("held", "late"), [("after", 0), ("before", 1)])
def test_a_replay_repeats_the_reference_engine(held, late):
    declared = replace(robot.declared(), period=2e-3)
    shown = (np.concatenate([f[:1].repeat(late), f[: f.size - late]]) for f in _forces())
    run = robot.replay(**{FORCE_HELD: np.full(2, HELD.index(held))})
    run = replace(run, inputs=run.inputs | dict(zip(("force_x", "force_y"), shown, strict=True)))
    predictor = ScenarioPredictor(declared, TipRig(holds=True))
    told = predictor.predict({p.name: p.value for p in predictor.parameters}, [run])
    expected = _reference(declared)
    assert np.ptp(expected, axis=0).min() > 0.01
    for j in range(2):
        assert np.abs(told[f"position_{j + 1}"][0] - expected[:, j]).max() < 1e-7
