"""A step of a driver is there at once: as a slope of one row it would be half a row late."""

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.stale import stepped_inputs

ROWS = 320
STEPS = np.repeat([-2.0, -1.9, 1.0, 0.0], ROWS // 4)


def remarks(*runs, held=None, signal="drive", role="input"):
    stated = {} if held is None else {"held": held, "held_stated": True}
    channel = ChannelMap(signal, "u", "V", role, **stated)
    return stepped_inputs([(np.arange(x.size), {signal: x}) for x in runs], {signal: channel})


@pytest.mark.parametrize("signal", ["drive", "duty", "reference", "drive_1"])
def test_it_is_told_what_to_write(signal):
    (one,) = remarks(STEPS, signal=signal)
    assert one.what.startswith(f"{signal} changes in steps")
    assert one.value == "3 of 320 rows"
    assert 'held = "after"' in one.right


def test_a_single_step_in_each_run_is_one():
    assert len(remarks(STEPS[:160], STEPS[160:])) == 1


@pytest.mark.parametrize("values", [
    np.zeros(ROWS), np.sin(0.05 * np.arange(ROWS)), np.clip(np.arange(ROWS) - 100.0, 0.0, 10.0),
    np.repeat(np.arange(80.0), 4), np.round(np.linspace(0.0, 1.0, ROWS) / 0.04) * 0.04,
    np.append(np.zeros(ROWS), 1.0),
])  # fmt: skip
def test_what_stays_goes_on_or_ramps_is_none(values):
    assert remarks(values) == []


def test_a_row_without_a_value_hides_no_step():
    values = STEPS.copy()
    values[10] = np.nan
    assert len(remarks(values)) == 1


def test_what_is_held_or_sensed_is_none():
    assert remarks(STEPS, held="after") == []
    assert remarks(STEPS, held="sampled") == []
    assert remarks(STEPS, signal="current") == []
