"""Words of the lock-up comparison: runs arrive, come to rest, or creep."""

import pytest

from simpter_hybrid.reproduce.lockup import Progress, went

ARRIVES, RESTS, CREEPS = Progress(True, 9.0), Progress(False, 0.0), Progress(False, 1.5)


@pytest.mark.parametrize(
    ("runs", "words"),
    [
        ([ARRIVES, ARRIVES], "all of 2 runs arrive"),
        ([RESTS, RESTS], "2 of 2 runs come to rest and 0 creep"),
        ([RESTS, CREEPS], "1 of 2 runs come to rest and 1 creep (2.00 Hz, 1.5 in in 6 s)"),
    ],
)
def test_every_run_is_told_once(runs, words):
    assert went([(1.0 + k, run) for k, run in enumerate(runs)]) == words
