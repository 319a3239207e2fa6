"""The Ishigami function, whose indices are known, through the sweep's design and estimator."""

import numpy as np
import pytest

from simpter_hybrid.problems import Problems
from simpter_hybrid.sweeps.axis import number_of, read_axis
from simpter_hybrid.sweeps.design import design
from simpter_hybrid.sweeps.sobol import sobol_indices

A, B = 7.0, 0.1
N = 4096
#: Standard error that as many random points would have; scrambled Sobol points have less.
NEAR = N**-0.5


def ishigami(x):
    return np.sin(x[..., 0]) + A * np.sin(x[..., 1]) ** 2 + B * x[..., 2] ** 4 * np.sin(x[..., 0])


@pytest.fixture(scope="module")
def points():
    problems = Problems("test")
    texts = [f"x{k}=-3.14159265359..3.14159265359" for k in (1, 2, 3)]
    axes = [read_axis(text, problems) for text in texts]
    made = design(axes, problems, sample=N, method="saltelli", seed=1)
    return np.array([[number_of(value)[0] for value in row] for row in made.rows])


def closed_form():
    """Ishigami and Homma (1990), ISUMA: variances of the terms."""
    v1 = 0.5 * (1.0 + B * np.pi**4 / 5.0) ** 2
    v2 = A**2 / 8.0
    v13 = B**2 * np.pi**8 * 8.0 / 225.0
    v = v1 + v2 + v13
    return np.array([v1, v2, 0.0]) / v, np.array([v1 + v13, v2, v13]) / v


def test_indices_and_intervals(points):
    found = sobol_indices(("x1", "x2", "x3"), ishigami(points), resamples=200)
    first, total = closed_form()
    assert found.first == pytest.approx(first, abs=NEAR)
    assert found.total == pytest.approx(total, abs=NEAR)
    for values, interval in ((first, found.first_interval), (total, found.total_interval)):
        assert (interval[:, 0] <= values + 1e-9).all()
        assert (values <= interval[:, 1] + 1e-9).all()
        assert (interval[:, 1] - interval[:, 0] < 0.2).all()


def test_scipy_estimates_the_same_from_the_same_values(points):
    from scipy.stats import sobol_indices as scipys

    blocks = ishigami(points).reshape(5, N)
    mine = sobol_indices(("x1", "x2", "x3"), blocks.ravel(), resamples=2)
    given = {"f_A": blocks[:1], "f_B": blocks[1:2], "f_AB": blocks[2:, None]}
    theirs = scipys(func=given, n=N)
    # Both are the same sums; SciPy may centre them differently.
    assert mine.first == pytest.approx(theirs.first_order.ravel(), abs=2e-3)
    assert mine.total == pytest.approx(theirs.total_order.ravel(), abs=2e-3)


def test_a_failed_case_leaves_out_its_row_only(points):
    values = ishigami(points)
    values[[5, N + 70, 3 * N + 70]] = np.nan
    found = sobol_indices(("x1", "x2", "x3"), values, resamples=2)
    assert (found.used, found.dropped) == (N - 2, 2)
    assert found.first == pytest.approx(closed_form()[0], abs=NEAR)


@pytest.mark.filterwarnings("error")
def test_what_does_not_vary_has_no_indices():
    found = sobol_indices(("x1", "x2"), np.ones(64), resamples=5)
    assert not np.isfinite(found.first).any()
    assert found.variance == 0.0
