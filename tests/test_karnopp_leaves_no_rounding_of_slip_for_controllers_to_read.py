"""A held clutch has slip zero, not 1e-17, of which a controller would read the sign."""

import itertools

import numpy as np
import pytest
from karnopp_states import C
from random_runs import random_run

from simpter_hybrid.compiled import simulate as exact
from simpter_hybrid.karnopp import simulate
from simpter_hybrid.karnopp.general import rest

MAP = np.reshape(C, (4, 2))


@pytest.mark.parametrize(
    "held", [s for k in (1, 2, 3, 4) for s in itertools.combinations(range(4), k)]
)
def test_the_limited_speeds_of_pter_have_exactly_no_slip(held):
    rng = np.random.default_rng(sum(held))
    flags = [int(i in held) for i in range(4)]
    for _ in range(50):
        free = np.linalg.svd(MAP[list(held)])[2][np.linalg.matrix_rank(MAP[list(held)]) :]
        rounded = free.T @ rng.normal(size=len(free)) + rng.normal(scale=1e-17, size=2)
        speed = rounded.tolist()
        rest(2, 4, C, flags, [0.0] * 40, [0.0] * 4, speed)
        assert [float(MAP[i] @ speed) for i in held] == [0.0] * len(held)
        # Only the rounding goes.
        assert speed == pytest.approx(rounded.tolist(), abs=1e-15)


def test_three_coordinates_and_five_clutches_lose_no_more_than_rounding():
    rng = np.random.default_rng(1)
    for held in itertools.combinations(range(5), 2):
        rows = rng.normal(size=(5, 3))
        speed = rng.normal(size=3)
        speed -= np.linalg.pinv(rows[list(held)]) @ rows[list(held)] @ speed
        moved = speed.tolist()
        rest(
            3, 5, rows.ravel().tolist(), [int(i in held) for i in range(5)], [0.0] * 60,
            [0.0] * 5, moved,
        )  # fmt: skip
        # A pivot of the elimination may be some 1e-3 of the row.
        assert moved == pytest.approx(speed.tolist(), abs=1e-12)


def test_a_sampled_controller_sees_the_same_signs_as_in_the_exact_run():
    scenario = random_run("controller 30 Hz", 54)
    reference, run = exact(scenario), simulate(scenario, 1e-7, rtol=1e-9, atol=1e-12)
    reach = np.abs(reference.step_y[:, :2] - reference.step_y[0, :2]).max()
    # With the signs of rounding it ends 20 % away; the band costs about its square root.
    assert np.abs(run.end - reference.end)[:2].max() < 1e-3 * reach
