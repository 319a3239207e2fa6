"""What a worker process raises says the same where it arrives."""

import pickle

import pytest

from simpter_hybrid.problems import CompiledUnavailable, InvalidInput, Problem


@pytest.mark.parametrize(
    "error",
    [
        InvalidInput([Problem("a.toml", "load.angle", "no unit", "3", "an angle")] * 2),
        CompiledUnavailable("no compiler", "none", "llvmlite", "leave it off"),
    ],
    ids=lambda e: type(e).__name__,
)
def test_an_error_is_the_same_after_pickling(error):
    again = pickle.loads(pickle.dumps(error))
    assert type(again) is type(error)
    assert (str(again), vars(again)) == (str(error), vars(error))
