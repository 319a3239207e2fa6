"""Nothing in a run's files depends on when or where it was made."""

import pytest
from sampled_runs import baseline, oscillator, same_again

from simpter_hybrid.files.storage import save


@pytest.mark.parametrize("run", [baseline, oscillator])
def test_the_same_run_saved_twice_gives_the_same_bytes(run, tmp_path):
    one = save(run(), tmp_path / "one", "name = 'a'\n")
    two = save(same_again(run()), tmp_path / "elsewhere" / "two", "name = 'a'\n")
    names = sorted(file.name for file in one.iterdir())
    assert names == ["events.csv", "scenario.toml", "summary.json", "trajectory.npz"]
    for name in names:
        assert (one / name).read_bytes() == (two / name).read_bytes()
