"""An interrupt before the first segment leaves a run that is empty, and says so."""

import pytest

import simpter_hybrid as simpter


def at_once(t):
    raise KeyboardInterrupt


def test_it_is_saved_and_says_that_there_is_nothing_to_draw(tmp_path):
    trajectory = simpter.run("line-y24", progress=at_once)
    assert (trajectory.status, len(trajectory.segment_t)) == ("interrupted", 0)
    simpter.save(trajectory, tmp_path / "run")
    trajectory = simpter.load_run(tmp_path / "run")
    assert trajectory.t_end == 0.0
    assert list(trajectory.state(0.0)) == list(trajectory.end)
    with pytest.raises(ValueError, match=r"nothing to draw: interrupted at t = 0.0 s"):
        simpter.plot(trajectory, tmp_path / "pictures")
    assert not (tmp_path / "pictures").exists()
