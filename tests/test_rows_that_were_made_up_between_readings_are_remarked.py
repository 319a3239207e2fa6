"""A slow log put between the rows of a fast one by straight lines holds no noise there."""

import numpy as np
import pytest
from axis_recordings import MAP, written

from simpter_hybrid.identification.recordings.between_readings import corners_apart

READ = np.sin(0.05 * np.arange(300)) + 0.01 * np.random.default_rng(1).standard_normal(300)


@pytest.mark.parametrize("every", [2, 3, 10])
@pytest.mark.parametrize("digits", [4, 6])
def test_corners_at_every_so_many_rows_tell_how_many_were_made_up(every, digits):
    rows = np.interp(np.arange(299 * every) / every, np.arange(300), READ)
    assert corners_apart(np.round(rows, digits)) == every


@pytest.mark.parametrize(
    "course",
    [
        READ,
        np.round(READ, 1),
        np.repeat(READ, 4),
        np.sin(0.01 * np.arange(900)),
        np.zeros(99),
        *(
            np.interp(np.arange(900), np.arange(0, 901, k), np.arange(900 // k + 1) % 2)
            for k in (10, 20)
        ),
    ],
    ids=["noisy", "coarse", "held", "smooth", "rest", "triangles", "slow triangles"],
)
def test_readings_have_them_anywhere(course):
    assert corners_apart(course) == 1


def test_it_is_said_once_for_a_channel(tmp_path):
    made = np.interp(np.arange(1490) / 5, np.arange(300), READ)
    rows = ["take,ms,angle,torque"] + [
        f"{take},{4 * k},{(take + 1) * angle:.5f},{np.sin(k):.4f}"
        for take in range(3)
        for k, angle in enumerate(made)
    ]
    told = [f for f in written(tmp_path, rows, MAP).findings if "made up" in f.what]
    assert [(f.run, f.value) for f in told] == [("take 0", "4 of 5 rows")]
