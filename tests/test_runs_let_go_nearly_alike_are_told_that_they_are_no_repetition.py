"""Who lets a device go several times expects that the runs tell its noise: near ones are named."""

from dataclasses import replace

import numpy as np
import pytest
from toy_rig import toy_replay

from simpter_hybrid.identification.fitting.replay import Restart
from simpter_hybrid.identification.reporting.nearly_repeated import nearly_repeated_sentence


def _released(*places, whole=True):
    """Runs that swing from these places."""
    return [
        replace(
            toy_replay(f"from {place}", 1),
            drive_is_exact=False,
            notes={"position": place * np.cos(np.linspace(0.0, 30.0, 2000))},
            followed=(Restart(500, 0.0, 0.0),) * whole,
        )
        for place in places
    ]


def test_those_that_agree_by_the_bound_of_others_alone():
    said = nearly_repeated_sentence(_released(1.0, 0.92))
    assert "not all counted as repeated: from 1.0 and from 0.92." in said
    assert "within 2 %" in said
    assert "within 15 % only" in said


@pytest.mark.parametrize(
    "runs", [_released(1.0, 0.99), _released(1.0, 0.5), _released(1.0, 0.92, whole=False)]
)
def test_none_that_count_or_are_far_off_or_are_cut_in_windows(runs):
    assert nearly_repeated_sentence(runs) == ""


def test_those_among_which_some_count_are_told_as_well():
    said = nearly_repeated_sentence(_released(1.0, 0.99, 0.92))
    assert "from 1.0 and from 0.99 and from 0.92" in said
