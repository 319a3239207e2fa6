"""Save and load: every array, every event, every evaluation the same."""

import dataclasses

import numpy as np
import pytest
from sampled_runs import baseline, oscillator

from simpter_hybrid.files.storage import StoredRunError, load, save
from simpter_hybrid.measuring.sampling import output_grid, sample


@pytest.mark.parametrize("run", [baseline, oscillator])
def test_every_field_is_the_same(run, tmp_path):
    trajectory = run()
    again = load(save(trajectory, tmp_path / "run"), trajectory.scenario)
    for field in dataclasses.fields(trajectory):
        one, two = getattr(trajectory, field.name), getattr(again, field.name)
        if isinstance(one, np.ndarray):
            assert one.dtype == two.dtype
            assert np.array_equal(one, two)
        else:
            assert one == two


def test_evaluations_are_the_same(tmp_path):
    again = load(save(baseline(), tmp_path / "run"), baseline().scenario)
    grid = output_grid(baseline())
    one, two = sample(baseline(), *grid), sample(again, *grid)
    for name in ("q", "qdd", "slip", "tau", "tau_break_forward", "margin", "tip_acceleration"):
        assert np.array_equal(getattr(one, name), getattr(two, name))


def test_another_scenario_is_refused(tmp_path):
    run = oscillator()
    save(run, tmp_path / "run")
    stiffer = dataclasses.replace(run.scenario.device, stiffness=51.0)
    with pytest.raises(StoredRunError, match=r"device\.stiffness is 51\.0, but was 50\.0"):
        load(tmp_path / "run", run.scenario.replace(device=stiffer))


def test_a_damaged_file_says_so(tmp_path):
    save(oscillator(), tmp_path / "run")
    (tmp_path / "run" / "trajectory.npz").write_bytes(b"not a run")
    with pytest.raises(StoredRunError, match="run the scenario again"):
        load(tmp_path / "run", oscillator().scenario)
    with pytest.raises(StoredRunError, match=r"holds no trajectory.npz"):
        load(tmp_path, oscillator().scenario)
    with pytest.raises(StoredRunError, match=r"holds no scenario.toml"):
        load(tmp_path / "run")
