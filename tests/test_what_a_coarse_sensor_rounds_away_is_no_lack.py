"""Rounding that no noise carries values across comes again: it is allowed for, not explained."""

from types import SimpleNamespace

import numpy as np
import pytest
from axis_recordings import declared_axis, recorded_axis
from coarse_force import FORCE, STEP, moved_bench, rounded_force

from simpter_hybrid.identification.axis.bench import axis_bench
from simpter_hybrid.identification.axis.noise_allowed import rounded
from simpter_hybrid.identification.axis.prescribed_bench import rounded as part_rounded
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.fitting.replay import beyond_rounding
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.recordings.noise import coarse_step, driven_step
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.identification.rigs.input_noise import left_out
from simpter_hybrid.identification.tracing.limits import (
    OFF_NOISE,
    ROUNDED_AXIS,
    SIMULATED_AXIS,
    known_by_repetition,
)
from simpter_hybrid.identification.tracing.rivals import LEAST_GAIN

NOISE = np.random.default_rng(3).normal(0.0, 0.01, 1000)


@pytest.mark.parametrize(("noise", "step"), [(0.02, STEP), (0.1, STEP), (0.4, None)])
def test_noise_that_carries_values_across_makes_a_step_no_matter(noise, step):
    assert coarse_step(rounded_force(noise)) == (None if step is None else pytest.approx(step))


def test_what_is_left_out_stays_while_a_value_does_and_is_at_most_half_a_step():
    values = rounded_force(0.0)
    drawn = left_out(values, np.random.default_rng(2))
    assert np.abs(drawn).max() <= STEP / 2.0
    stays = np.diff(values) == 0.0
    assert not np.diff(drawn)[stays].any()
    assert np.diff(drawn)[~stays].all()
    assert not left_out(FORCE, np.random.default_rng(2)).any()


@pytest.mark.parametrize(("levels", "is_rounded"), [((-4.0, 4.0), False), ((-4.0, 0.0, 4.0), False),
                                                 ((-4.0, -2.0, 2.0, 4.0), True)])  # fmt: skip
def test_a_current_that_a_relay_switches_is_not_rounded(levels, is_rounded):
    values = np.repeat(np.tile(levels, 20), 25)
    assert (driven_step(values) is not None) is is_rounded
    assert left_out(values, np.random.default_rng(2)).any() == is_rounded


def test_a_force_as_it_was_rounded_differs_by_nothing_from_what_was_rounded():
    values = rounded_force(0.0)
    assert not beyond_rounding(values - FORCE, STEP).any()
    told = beyond_rounding(values - 0.5 * FORCE, STEP)
    assert np.abs(told).max() == pytest.approx(2.5 - STEP, abs=STEP / 2.0)
    np.testing.assert_array_equal(beyond_rounding(FORCE, 0.0), FORCE)


def test_more_is_asked_of_an_effect_where_a_force_is_rounded_coarsely(tmp_path):
    coarse = moved_bench(tmp_path, 0.02)
    assert part_rounded(coarse.parts["fit"]) > 0.5
    assert min(c.least for c in coarse.candidates) > 2.0 * LEAST_GAIN
    fine = moved_bench(tmp_path, 0.4)
    assert part_rounded(fine.parts["fit"]) == 0.0
    assert min(c.least for c in fine.candidates) < LEAST_GAIN


@pytest.mark.parametrize("step", [0.1, 0.0])
def test_of_a_coarse_drive_the_floor_is_known_roughly(tmp_path, step):
    def shown(drive):
        return step * np.round(drive / step) if step else drive + NOISE

    recording = recorded_axis(tmp_path, [], shown=shown)
    bench = axis_bench(recording, declared_axis(), groups_of(recording))
    assert bench.limits.coarse == (step > 0.0)
    assert (bench.limits.clean == ROUNDED_AXIS.clean) == (step > 0.0)


def test_repeated_runs_do_not_make_a_roughly_known_floor_a_sure_one():
    assert known_by_repetition(ROUNDED_AXIS, 2.0, 0.02).clean == ROUNDED_AXIS.clean
    # What it rounds away of a right model comes again: it was 2.3 times the floor of a null.
    assert known_by_repetition(ROUNDED_AXIS, 1.0, 0.02).lack >= 2.3
    finer = ROUNDED_AXIS._replace(clean=1.0, form=1.0)
    assert known_by_repetition(finer, 2.0, 0.02).clean == OFF_NOISE


@pytest.mark.parametrize("rounds", [True, False])
def test_what_an_encoder_leaves_a_right_model_comes_again(rounds):
    # A null with slow noise of its force, each push given twice, left 1.37 times the floor.
    known = known_by_repetition(SIMULATED_AXIS._replace(rounds=rounds), 1.0, 0.02)
    assert (known.lack > 1.37) == rounds


@pytest.mark.parametrize("step", [0.1, 0.0])  # [deg], with noise of 0.011
def test_an_encoder_is_one_that_noise_does_not_carry_across(tmp_path, step):
    recorded_axis(tmp_path, [])
    if step:
        data = (tmp_path / "data.csv").read_text(encoding="utf-8").splitlines()
        rows = [row.split(",") for row in data[1:]]
        cells = [[r[0], r[1], f"{step * round(float(r[2]) / step):.5f}", *r[3:]] for r in rows]
        (tmp_path / "data.csv").write_text("\n".join([data[0], *map(",".join, cells)]))
    recording = load_recording(tmp_path / "data.csv", tmp_path / "map.toml")
    bench = axis_bench(recording, declared_axis(), groups_of(recording))
    assert bench.limits.rounds == (step > 0.0)


@pytest.mark.parametrize(("step", "coarse"), [(1e-2, True), (1e-4, False)])
def test_digits_that_were_written_are_no_coarse_sensor(step, coarse):
    force = step * np.round(FORCE / step)  # over 10 N
    run = SimpleNamespace(channels={"force": force})
    channels = {"force": SimpleNamespace(noise=None)}
    recording = SimpleNamespace(channels=channels, runs=[run])
    assert driven_step(force) == pytest.approx(step)
    assert rounded(recording, AxisSignals()) is coarse
