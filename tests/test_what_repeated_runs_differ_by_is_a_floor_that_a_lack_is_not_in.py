from dataclasses import replace

import numpy as np
import pytest
from toy_rig import ToyRig, toy_replay

from simpter_hybrid.identification.fitting.floor import Floors
from simpter_hybrid.identification.fitting.repeats import repeated_floor, repeated_over, repetitions
from simpter_hybrid.identification.fitting.replay import Restart

VALUES = {"scale": 1.0}


def measured(name: str, seed: int, **kind):
    """A run whose drive was measured, with noise that is slow: each of 20 samples the same."""
    run = toy_replay(name, seed, noise=0.0, **kind)
    slow = np.repeat(np.random.default_rng(seed).standard_normal(run.time.size // 20), 20)
    seen = run.observed["torque"]
    seen = replace(seen, values=seen.values + 0.1 * slow, sd=0.1)
    return replace(run, drive_is_exact=False, observed={"torque": seen})


def floor_of(runs):
    floor, _ = repeated_floor(ToyRig(), VALUES, repetitions(runs))
    return floor


def test_noise_of_any_colour_is_in_the_floor():
    runs = [measured(str(k), k) for k in range(1, 9)]
    # 8 runs of 100 draws: a standard deviation known to 2.7 % (one standard error); four of them.
    assert floor_of(runs) == pytest.approx(1.0, rel=0.11)


def test_a_lack_is_not_since_it_comes_again():
    noise = [measured(str(k), k) for k in range(1, 9)]
    lack = [measured(str(k), k, gain=3.0) for k in range(1, 9)]
    # What is left is clipped at 12 standard deviations, far above this lack: only rounding differs.
    assert floor_of(lack) == pytest.approx(floor_of(noise), rel=0.11)


def test_how_surely_it_is_known_is_seen_between_windows():
    """Four runs of 100 draws, less their mean: 300 free ones tell it to 1 / sqrt(600)."""
    runs = [measured(str(k), k) for k in range(1, 5)]
    _, sure = repeated_floor(ToyRig(), VALUES, repetitions(runs))
    # Forty windows tell that to a sixth (one standard error); two of them.
    assert sure == pytest.approx(1 / np.sqrt(600), rel=0.33)


def test_it_is_that_of_the_part_whose_runs_were_repeated():
    def louder(run):
        seen = run.observed["torque"]
        return replace(run, observed={"torque": replace(seen, sd=seen.sd / 3)})

    calm = [measured(str(k), k) for k in range(1, 9)]
    loud = [louder(measured(str(k), k, experiment="B")) for k in range(9, 17)]
    models = [(ToyRig(), VALUES)]
    times = repeated_over(Floors(1.0, 2.0, 4.0), models, {"fit": calm, "select": loud}).times
    assert times.fit == pytest.approx(1.0, rel=0.11)
    assert times.select == pytest.approx(3.0 / 2.0, rel=0.11)
    # Of the runs that report nothing is asked: as the others, in the mean square of both.
    assert times.report == pytest.approx(np.sqrt((1 + 9) / (1 + 4)), rel=0.11)
    assert repeated_over(Floors(1.0, 1.0, 1.0), models, {"fit": calm[:1], "select": []}) is None


class Failing(ToyRig):
    """A model that predicts nothing."""

    def predict(self, values, replays):
        return {"torque": [np.full(r.time.size, np.nan) for r in replays]}


def test_a_model_that_fails_says_nothing_of_it_wherever_it_stands():
    runs, ones = [measured(str(k), k) for k in range(1, 9)], Floors(1.0, 1.0, 1.0)
    models = [(ToyRig(), VALUES), (Failing(), VALUES)]
    for order in (models, models[::-1]):
        times = repeated_over(ones, order, {"fit": runs, "select": []}).times
        assert times.fit == pytest.approx(1.0, rel=0.11)
    assert repeated_over(ones, models[1:], {"fit": runs, "select": []}) is None


def test_runs_of_another_course_are_no_repetitions():
    other = [measured("1", 1), measured("2", 2, experiment="another")]
    assert repetitions(other) == []
    assert np.isnan(floor_of(other))


def test_runs_that_were_told_the_same_are_left_to_the_replicate_floor():
    assert repetitions([toy_replay("1", 1), toy_replay("2", 2)]) == []


def test_a_run_that_is_followed_whole_is_repeated_only_from_nearly_the_same_start():
    def released(from_, followed):
        course = {"position": from_ * np.cos(np.linspace(0.0, 30.0, 2000))}
        run = replace(measured(str(from_), 1), notes=course)
        return replace(run, followed=(Restart(500, 0.0, 0.0),) if followed else ())

    for followed in (False, True):
        near, far = ([released(1.0, followed), released(x, followed)] for x in (0.99, 0.92))
        assert len(repetitions(near)) == 1
        assert len(repetitions(far)) == (0 if followed else 1)


def test_runs_of_another_setting_are_none_either():
    runs = [
        replace(measured(str(k), k), setting={"mass": mass}) for k, mass in enumerate((1, 1, 2))
    ]
    assert [[r.name for r in group] for group in repetitions(runs)] == [["0", "1"]]
