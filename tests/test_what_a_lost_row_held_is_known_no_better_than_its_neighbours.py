"""An input that holds from row to row is uncertain where rows were lost, and nowhere else."""

import numpy as np
import pytest

from simpter_hybrid.identification.rigs.input_noise import in_lost_rows

TIME = 0.002 * np.delete(np.arange(20), [4, 8, 9])  # one row lost, then two
DRIVE = np.delete(np.arange(20.0), [4, 8, 9])


def drawn(held, time=TIME):
    """Largest and mean of many draws, by row."""
    generator = np.random.default_rng(1)
    many = [in_lost_rows(DRIVE[: time.size], time, held, generator) for _ in range(2000)]
    return np.max(np.abs(many), axis=0), np.mean(many, axis=0)


@pytest.mark.parametrize(
    ("held", "rows", "way"), [("after", [3, 6], 1.0), ("before", [4, 7], -1.0)]
)
def test_up_to_the_part_that_was_lost_of_the_way_to_the_neighbour(held, rows, way):
    most, mean = drawn(held)
    assert np.flatnonzero(most).tolist() == rows
    # Half of a way of 2, two thirds of one of 3; the mean of 2000 uniform draws is known to 2 %.
    assert most[rows] == pytest.approx([1.0, 2.0], rel=0.01)
    assert mean[rows] == pytest.approx([way * 0.5, way * 1.0], rel=0.06)


@pytest.mark.parametrize(
    "time",
    [0.002 * np.arange(9) + 0.0006 * (np.arange(9) % 2), np.cumsum([0, 1, 3, 1, 4, 1, 3, 1, 5])],
    ids=["jitter", "as they come"],
)
def test_rows_that_only_jitter_or_come_irregularly_are_not_lost(time):
    generator, other = np.random.default_rng(1), np.random.default_rng(1)
    assert not in_lost_rows(DRIVE[:9], time, "after", generator).any()
    if time.dtype.kind == "f":  # no draw of the noise of the rest is moved
        assert generator.uniform() == other.uniform()


def test_of_a_single_row_none_is_lost():
    alone = in_lost_rows(DRIVE[:1], TIME[:1], "after", np.random.default_rng(1))
    assert alone.tolist() == [0.0]
