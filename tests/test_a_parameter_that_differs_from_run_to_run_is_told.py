from dataclasses import replace

import numpy as np
import pytest
from toy_rig import ToyRig, toy_replay

from simpter_hybrid.identification.fitting.fitted_model import Split, refitted
from simpter_hybrid.identification.going_with import goes_with
from simpter_hybrid.identification.own_values import run_levels
from simpter_hybrid.identification.reporting.level_sentences import levels_text
from simpter_hybrid.identification.run_levels import (
    RunLevels,
    differs,
    likeliest,
    odd_run,
)

SCALES = (0.9, 1.0, 1.1, 0.95, 1.05)


def model_of(runs):
    return refitted(ToyRig(), Split(runs, runs, runs))


def test_each_run_gets_the_value_it_was_made_with():
    runs = [toy_replay(str(k), k, scale=s) for k, s in enumerate(SCALES)]
    found = run_levels(model_of(runs), runs, floor=1.0)
    told = np.array([level for _, level in found.levels])
    # Half a run's 1000 samples of 1.06 rms with noise 0.1 know a scale to 0.003; three of them.
    assert told == pytest.approx(np.array(SCALES) / np.median(SCALES), abs=0.009)
    assert found.parameter == "scale"
    assert differs(found)
    assert found.after == pytest.approx(1.0, abs=0.05)  # five runs: 1.4 %, three of them


def test_runs_whose_names_end_like_those_of_pieces_keep_their_order():
    levels = (("take 2, part 1", 1.2), ("take 1, part 2, part 2", 1.0), ("take 1, part 2", 0.8))
    found = RunLevels("scale", levels, 1.0, 0.5, 0.9)
    ordered = found.in_order(["take 1, part 2", "take 2, part 1"]).levels
    assert [name for name, _ in ordered] == [levels[1][0], levels[2][0], levels[0][0]]


def test_another_load_is_no_matter_of_a_tolerance():
    scales = (0.4, 1.0, 2.2, 0.4, 1.0, 2.2)  # the fit of a common scale may go from 0.5 to 1.5
    runs = [toy_replay(str(k), k, scale=s) for k, s in enumerate(scales)]
    found = run_levels(model_of(runs), runs, floor=1.0)
    told = np.array([level for _, level in found.levels])
    assert told == pytest.approx(np.array(scales) / np.median(scales), abs=0.009)
    assert differs(found)


def test_each_run_gets_its_value_where_only_every_second_window_tells_of_it():
    runs = []
    for k, scale in enumerate(SCALES):
        run = toy_replay(str(k), k, scale=scale)
        told = run.time % 1.0 < 0.5  # as a mass shows in windows in which it is accelerated
        told_by = np.where(told, run.inputs["u"], 0.0)
        seen = run.observed["torque"]
        values = seen.values - scale * (run.inputs["u"] - told_by)
        runs.append(
            replace(
                run,
                inputs={**run.inputs, "u": told_by},
                observed={"torque": replace(seen, values=values)},
            )
        )
    found = run_levels(model_of(runs), runs, floor=1.0)
    told = np.array([level for _, level in found.levels])
    # Half the samples.
    assert told == pytest.approx(np.array(SCALES) / np.median(SCALES), abs=0.013)
    assert differs(found)


def test_of_parameters_that_do_as_well_it_is_the_one_known_least():
    runs = (("a", 0.5), ("b", 1.5))
    mass = RunLevels("mass", runs, 9.0, 1.0, 0.99, apart=50.0)
    friction = RunLevels("friction", runs, 9.0, 1.04, 0.98, apart=2.0)
    drive = RunLevels("drive", runs, 9.0, 1.2, 0.97, apart=1.0)
    assert likeliest([mass, drive, friction]) is friction


def test_near_the_floor_what_does_nothing_does_not_do_as_well():
    idle = RunLevels("mass", (("a", 1.0), ("b", 1.0)), 1.03, 1.03, 0.0)
    friction = RunLevels("friction", (("a", 0.97), ("b", 1.03)), 1.03, 1.0, 1.0, apart=2.0)
    assert likeliest([idle, friction]) is friction


def test_a_lack_that_is_in_every_run_alike_is_no_matter_of_runs():
    runs = [toy_replay(str(k), k, gain=0.3) for k in range(5)]
    assert not differs(run_levels(model_of(runs), runs, floor=1.0))


def test_noise_is_none_either():
    runs = [toy_replay(str(k), k) for k in range(5)]
    found = run_levels(model_of(runs), runs, floor=1.0)
    assert found.after == pytest.approx(found.before, rel=0.01)
    # Nor where what is left is below a floor that was put too high.
    assert not differs(run_levels(model_of(runs), runs, floor=1.2))


def test_what_own_values_do_worse_is_no_share():
    worse = RunLevels("mass", (("a", 1.0), ("b", 1.0)), 2.0, 2.1, -0.05)
    assert "takes away 0 % of what is left" in levels_text([worse], floor=1.0)


def test_values_that_are_the_same_in_every_run_are_of_a_number_that_is_off():
    found = RunLevels("inertia", (("a", 1.0), ("b", 1.0)), 2.0, 1.0, 0.9, {}, 3.0)
    assert not differs(found)
    said = levels_text([found], floor=1.0)
    assert said.startswith(
        "inertia of 3 times what is declared, in every run alike, takes away 90 %"
    )


def told_of(times):
    """What is said of runs that were fitted in another order than they were recorded in."""
    levels = tuple((f"run {k}, part 2" if k == 4 else f"run {k}", v) for k, v in enumerate(times))
    mixed = RunLevels("friction", levels[::2] + levels[1::2], 2.0, 1.0, 0.9)
    return levels_text([mixed.in_order([f"run {k}" for k in range(len(times))])], floor=1.0)


def test_a_value_that_falls_in_the_order_of_the_runs_is_said_to_do_so():
    falling = (1.2, 1.11, 1.02, 0.91, 0.88, 0.878)
    assert "it falls in the order of the runs" in told_of(falling)
    assert "it rises in the order of the runs" in told_of(falling[::-1])


def test_a_value_that_goes_up_and_down_is_not_nor_one_of_few_runs():
    assert "order" not in told_of((1.2, 0.9, 1.02, 0.91, 1.1, 0.878))
    assert "order" not in told_of((1.2, 1.1, 1.0, 0.9))


def test_a_value_that_follows_a_logged_channel_is_said_to_follow_it_and_not_the_order():
    times = (1.2, 0.9, 1.02, 0.91, 1.1, 0.95, 1.07)
    runs = tuple((f"run {k}", v) for k, v in enumerate(times))
    # Warm runs have little friction; the pressure of the day goes up and down.
    degrees = {run: 60.0 - 30.0 * v for run, v in runs}
    pressure = {run: 1.0 + 0.01 * (-1) ** k for k, (run, _) in enumerate(runs)}
    logged = {"day_pressure": pressure, "oil_temperature": degrees}
    found = RunLevels("friction", runs, 2.0, 1.0, 0.9, logged)
    assert goes_with(found) == {"oil_temperature": pytest.approx(-1.0)}
    assert "it falls with oil temperature, which was logged" in levels_text([found], floor=1.0)


@pytest.mark.parametrize(
    ("times", "said"),
    [
        ((0.3, 0.75, 1.0, 1.8, 2.3), "rises with brake volts in all 5 runs (6 would be sure)"),
        ((2.3, 1.8, 1.0, 0.75), "falls with brake volts in all 4 runs (6 would be sure)"),
        ((0.3, 0.75, 1.8, 1.0, 2.3), ""),
        ((0.3, 1.0, 2.3), "with brake volts is asked of 4 runs and more (6 would be sure)"),
    ],
)
def test_of_few_runs_what_follows_a_channel_in_all_is_no_more_than_told(times, said):
    runs = tuple((f"run {k}", v) for k, v in enumerate(times))
    logged = {"brake_volts": {run: float(k) for k, (run, _) in enumerate(runs)}}
    found = RunLevels("drag", runs, 2.0, 1.0, 0.9, logged)
    assert goes_with(found) == {}
    told = levels_text([found], floor=1.0)
    assert said in told
    assert bool(said) == ("brake" in told)


def test_beside_three_channels_more_runs_are_needed():
    runs = tuple((f"run {k}", 1.0 + 0.1 * k) for k in range(6))
    ways = {"volts": 1.0, "degrees": -1.0, "pressure": 2.0}
    logged = {n: {run: way * k for k, (run, _) in enumerate(runs)} for n, way in ways.items()}
    told = levels_text([RunLevels("drag", runs, 2.0, 1.0, 0.9, logged)], floor=1.0)
    assert "rises with volts in all 6 runs (7 would be sure)" in told


def test_a_channel_that_is_the_same_in_all_runs_asks_for_no_more_of_them():
    runs = tuple((f"run {k}", v) for k, v in enumerate((1.0, 1.1, 1.2, 1.3, 1.4)))
    followed = {run: v for run, v in runs}
    idle = {name: dict.fromkeys(followed, 1.0) for name in ("setting", "supply", "load")}
    found = RunLevels("drag", runs, 2.0, 1.0, 0.9, {"volts": followed, **idle})
    assert "rises with volts in all 5 runs (6 would be sure)" in levels_text([found], floor=1.0)


def alike_of(times, others):
    """What is said of two parameters with these values in each run."""
    runs = [f"run {k}" for k in range(len(times))]
    first, last = (
        RunLevels(name, tuple(zip(runs, values, strict=True)), 2.0, 1.0, 0.9)
        for name, values in (("friction", times), ("mass", others))
    )
    return levels_text([first, last], floor=1.0)


def test_parameters_that_rise_and_fall_together_point_to_a_gain():
    times = (1.2, 0.9, 1.02, 0.91, 1.1, 0.95, 1.07)
    alike = [1.0 + 0.8 * (v - 1.0) for v in times]
    assert "together, as they do where the gain of the drive" in alike_of(times, alike)
    assert "together" not in alike_of(times, [2.0 - v for v in alike])
    assert "together" not in alike_of(times, alike[::-1])


@pytest.mark.parametrize(
    ("levels", "odd"),
    [
        ((0.963, 0.964, 0.9635, 0.963, 0.9638, 1.29), "5"),
        ((0.7, 1.1, 1.102, 1.098, 1.1, 1.101), "0"),
        ((0.9, 1.0, 1.1, 1.2, 1.3, 1.4), ""),
        ((0.799, 0.801, 1.6, 0.8), "2"),
        ((0.99, 1.01, 1.3, 1.0), ""),
        ((0.964, 0.964, 1.29), ""),
        ((1.0, 1.0, 1.0, 1.0, 1.0, 1.004), ""),
    ],
    ids=["one above", "one below", "all apart", "of four", "not so far", "few", "nearly one"],
)
def test_one_run_that_is_far_from_all_others_is_asked_about(levels, odd):
    found = RunLevels("mass", tuple((str(k), x) for k, x in enumerate(levels)), 9.0, 1.1, 0.99)
    assert odd_run(found) == odd
    said = levels_text([found], 1.0)
    assert (f"in {odd}, " in said and "of the same rig?" in said) is bool(odd)
