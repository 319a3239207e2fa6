"""Noise decides where windows begin: repeated runs are compared over those that they share."""

from dataclasses import replace

import numpy as np
import pytest
from toy_rig import ToyRig, toy_replay

from simpter_hybrid.identification.fitting.repeats import repeated_floor, repetitions

WINDOWS = (0, 300, 600, 900, 1200, 1500, 1800)


def cut(seed, windows, spoilt=slice(0, 0)):
    """A run with a measured drive, cut at some rows, with an error of 5 on some of them."""
    run = toy_replay(str(seed), seed)
    seen = run.observed["torque"]
    values = seen.values + 5.0 * np.isin(np.arange(2000), np.arange(2000)[spoilt])
    observed = {"torque": replace(seen, values=values, windows=windows)}
    return replace(run, drive_is_exact=False, observed=observed)


def test_a_run_with_one_window_fewer_is_a_repetition_all_the_same():
    runs = [cut(1, WINDOWS), cut(2, (*WINDOWS[:3], *WINDOWS[4:]))]
    assert [len(group) for group in repetitions(runs)] == [2]


def test_its_other_windows_are_not_compared():
    alike = cut(1, WINDOWS), cut(2, (*WINDOWS[:3], *WINDOWS[4:]))
    spoilt = cut(1, WINDOWS), cut(2, alike[1].observed["torque"].windows, slice(600, 1200))
    floors = [repeated_floor(ToyRig(), {"scale": 1.0}, [group])[0] for group in (alike, spoilt)]
    assert floors[1] == floors[0] == pytest.approx(1.0, rel=0.1)  # 1400 draws: to 2 %


def test_runs_of_which_most_windows_are_others_are_none():
    assert repetitions([cut(1, WINDOWS), cut(2, (0, *(k + 150 for k in WINDOWS[1:])))]) == []
