"""A limit of no steps at all is no setting of a run."""

import pytest

from simpter_hybrid.karnopp import Settings


@pytest.mark.parametrize("steps", [0, -3, float("nan")])
def test_the_limit_is_at_least_one(steps):
    with pytest.raises(ValueError, match=r"max_steps = .* must be at least 1"):
        Settings(max_steps=steps)
