"""Pieces of a motor's steady turning are at other places of its ripple: they tell no floor."""

from dataclasses import replace

import numpy as np
import pytest
from toy_rig import toy_replay

from simpter_hybrid.identification.fitting.repeats import repetitions


def run(name, seed, drive, **placed):
    made = toy_replay(name, seed)
    speed = drive + 0.01 * np.random.default_rng(seed).standard_normal(drive.size)
    return replace(
        made, drive_is_exact=False, inputs={"drive": drive, **placed}, notes={"speed": speed}
    )


STEADY, CHANGING = np.full(2000, 5.0), 5.0 + 3.0 * np.sin(0.01 * np.arange(2000))


@pytest.mark.parametrize(("drive", "count"), [(STEADY, 0), (CHANGING, 1)])
def test_what_changes_tells_where_it_is(drive, count):
    assert len(repetitions([run("a", 1, drive), run("b", 2, drive)])) == count


def test_so_does_a_known_place():
    place = 0.05 * np.arange(2000)
    runs = [run(name, k, STEADY, position=place) for k, name in enumerate("ab")]
    assert len(repetitions(runs)) == 1
