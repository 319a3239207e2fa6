"""In the recording's units, without what is not kept, in so few blocks that structure shows."""

from dataclasses import replace
from types import SimpleNamespace as Named

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.held_out_predictions import HeldOutPredictions, most_telling
from simpter_hybrid.plots.residual import POINTS, blocks, compared, moved_by_noise, residual

TIME = np.arange(20_000) * 1e-3
KEEP = (TIME < 5.0) | (TIME > 6.0)
RECORDING = Named(
    channels={"force": Named(unit="lbf", sign=1.0, shift=7.0, unit_scale=4.0, left=0.1)}, runs=()
)


def _told(change, channels=("force",)):
    seen = Observation(np.sin(TIME), 0.1, KEEP)
    replay = Replay("run 3", "stroke", TIME, {}, dict.fromkeys(channels, seen))
    before = {c: [np.sin(TIME) - 2.0] for c in channels}
    after = {c: [p[0] + change] for c, p in before.items()}
    return HeldOutPredictions([replay], before, after, None, most_telling([replay], before, after))


def _names(picture):
    return [text.get_text() for text in picture.legends[0].get_texts()]


def test_it_is_in_units_of_the_recording_and_without_its_shift():
    (panel,) = residual(_told(1.5), RECORDING).axes
    drawn = {line.get_label(): line.get_ydata() for line in panel.lines}
    assert np.nanmax(drawn["refitted"]) == pytest.approx(0.5)
    assert np.nanmax(drawn["corrected"]) == pytest.approx(0.125)
    assert "lbf" in panel.get_ylabel()


def test_where_nothing_was_corrected_only_the_refitted_model_is_drawn():
    assert "corrected" in _names(residual(_told(1.5)))
    assert "corrected" not in _names(residual(_told(0.0)))


def test_what_is_not_kept_is_left_out():
    told = _told(1.5)
    values = compared(told.replays[0].observed["force"], told.before["force"][0])
    assert (np.isnan(values) == ~KEEP).all()
    middle, mean, _, _ = blocks(TIME, values)
    assert np.isnan(mean[(middle > 5.1) & (middle < 5.9)]).all()
    assert np.isfinite(mean[(middle < 4.9) | (middle > 6.1)]).all()


@pytest.mark.parametrize("samples", [3, 399, 401, 123_456])
def test_blocks_are_few_and_hold_all(samples):
    values = np.arange(samples, dtype=float)
    _, mean, least, most = blocks(values, values)
    assert mean.size <= POINTS
    assert (least[0], most[-1]) == (0.0, samples - 1.0)
    assert ((least <= mean) & (mean <= most)).all()


def test_of_many_channels_four_are_drawn():
    assert len(residual(_told(1.5, [f"position_{k}" for k in range(1, 8)])).axes) == 4


def test_the_band_is_that_of_the_sensor_and_of_what_noisy_inputs_move():
    values, rows = np.zeros(200), np.arange(200)
    shape = np.where(rows[100:] < 125, 0.2, 0.0)[:, None]  # 25 rows: of length 1
    # What moves a prediction by 3 sensors' deviations along a curve counts 1 / sqrt(1 + 9).
    curves = ((np.zeros((100, 0)), np.zeros(0)), (shape, np.array([1.0 - 0.1**0.5])))
    seen = Observation(values, 1.0, values == 0.0, windows=(0, 100), curves=curves)
    band = moved_by_noise(seen, 0.5)
    assert band[rows < 125] == pytest.approx(0.5 * np.where(rows[:125] < 100, 1.0, 1.36**0.5))
    assert band[125:] == pytest.approx(0.5)


def test_a_start_that_is_fitted_is_no_noise():
    """What is drawn begins where it fits best, along curves on which nothing counts."""
    shape = np.ones((100, 1)) / 10.0
    seen = Observation(np.zeros(100), 0.5, np.ones(100, bool), windows=(0,))
    seen = replace(seen, curves=((shape, np.array([1.0 - 1e-6])),))
    assert moved_by_noise(seen, 0.5) == pytest.approx(np.full(100, 0.5))


def test_the_run_is_that_whose_error_falls_most_and_not_that_of_the_largest_spike():
    seen = Observation(np.sin(TIME), 0.1, KEEP)
    runs = [Replay(f"run {k}", "stroke", TIME, {}, {"force": seen}) for k in (1, 2)]
    spike = 9.0 * (np.arange(TIME.size) == 700)
    before = {"force": [np.sin(TIME) + spike, np.sin(TIME) - 1.0]}
    after = {"force": [np.sin(TIME), np.sin(TIME)]}
    found = most_telling(runs, before, after)
    assert (found.run, found.channel) == (1, "force")


def test_a_run_that_the_corrected_model_cannot_do_gains_nothing():
    seen = Observation(np.sin(TIME), 0.1, KEEP)
    runs = [Replay(f"run {k}", "stroke", TIME, {}, {"force": seen}) for k in (1, 2)]
    before = {"force": [np.sin(TIME) - 1.0, np.sin(TIME) - 0.2]}
    after = {"force": [np.full(TIME.size, np.nan), np.sin(TIME)]}
    assert most_telling(runs, before, after).run == 1


def test_a_spike_does_not_set_the_height_of_a_panel():
    told = _told(1.5)
    told.before["force"][0][700] -= 500.0
    (panel,) = residual(told, RECORDING).axes
    assert panel.get_ylim()[1] == pytest.approx(1.0)  # 2 times the half lbf of all else
