from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import t as student
from toy_rig import ALONG_X, ALONG_Y, ToyRig, toy_replay

from simpter_hybrid.identification.fitting.fit import Fitter
from simpter_hybrid.identification.fitting.identifiability import (
    Estimate,
    blind_to,
    confused,
    estimates,
    separation,
    visibility,
    widest,
)
from simpter_hybrid.identification.fitting.residual import weighted_residuals
from simpter_hybrid.identification.recordings.projection import beyond


@pytest.mark.parametrize("samples", [60, 200, 700, 2000])
@pytest.mark.parametrize("more", [(), (ALONG_Y,)])
def test_intervals_cover_the_truth_as_often_as_they_say(samples, more):
    rig = ToyRig().extended(ALONG_X)
    for candidate in more:
        rig = rig.extended(candidate)
    start = {p.name: p.value for p in rig.parameters}
    hits = 0
    for seed in range(200):
        replay = toy_replay("run", seed, gain=0.3, samples=samples)
        fit = Fitter(rig, [replay]).fit(start, iterations=8)
        found, _ = estimates(rig.parameters, fit, [replay])
        hits += abs(found[1].value - 0.3) <= found[1].half_width
    # 200 trials at 95 %: 190 expected, standard deviation 3.1.
    assert hits >= 190 - 3 * 3.1


def test_what_declared_parameters_imitate_is_not_seen():
    replay = toy_replay("run", 1)
    rig, nuisance = ToyRig().extended(ALONG_X), replay.inputs["u"][:, None]
    at = {"scale": 1.0, "gain": 0.0}
    without = weighted_residuals(rig, at, [replay])
    scaled = weighted_residuals(rig, at | {"scale": 1.1}, [replay])
    moved = weighted_residuals(rig, at | {"gain": 0.05}, [replay])
    hidden, seen = (beyond(changed - without, nuisance) for changed in (scaled, moved))
    assert visibility(hidden) == pytest.approx(0.0, abs=1e-12)
    # 0.05 sin over a noise of 0.1: mean square 1/8, so the error rises by sqrt(1 + 1/8) - 1.
    assert visibility(seen) == pytest.approx(np.sqrt(1.125) - 1, rel=0.03)
    assert blind_to({"hidden": hidden, "seen": seen}) == ("hidden",)


def test_two_effects_that_look_alike_are_a_pair_and_one_experiment_parts_them():
    time = np.arange(4000) * 0.01
    owner = (time >= 20.0).astype(int)
    one = np.sin(time)
    other = np.where(owner == 0, np.sin(time), np.cos(3 * time))
    first = owner == 0
    assert confused({"a": one[first], "b": other[first]})[0][:2] == ("a", "b")
    assert confused({"a": one, "b": other}) == ()
    apart = separation(one, other, owner, ("slow", "fast"))
    assert apart["slow"] == pytest.approx(0.0, abs=1e-9)
    assert next(iter(apart)) == "fast"


def test_a_projection_leaves_nothing_along_the_columns():
    generator = np.random.default_rng(1)
    columns, change = generator.standard_normal((50, 3)), generator.standard_normal(50)
    assert np.allclose(columns.T @ beyond(change, columns), 0.0, atol=1e-12)
    assert np.allclose(beyond(columns @ [1.0, 2.0, 3.0], columns), 0.0, atol=1e-12)


def test_the_part_imitated_is_what_a_projection_takes_away():
    one, other = np.random.default_rng(2).standard_normal((2, 50))
    other = 0.1 * other + one
    ((_, _, part),) = confused({"a": one, "b": other})
    rest = beyond(one, other[:, None])
    assert part == pytest.approx(1.0 - (rest @ rest) / (one @ one), rel=1e-12)


def test_what_the_data_do_not_show_has_no_finite_interval():
    replay = toy_replay("run", 1)
    replay.inputs["x"][:] = 0.0
    rig = ToyRig().extended(ALONG_X)
    fit = Fitter(rig, [replay]).fit({"scale": 1.0, "gain": 0.0}, iterations=2)
    found, _ = estimates(rig.parameters, fit, [replay])
    assert np.isfinite(found[0].half_width)
    assert found[1].half_width == np.inf


def test_of_two_steps_the_less_sure_tells_unless_it_shows_nothing():
    sure, less, blind = (Estimate("a", 1.0, width, "1") for width in (1e-5, 0.1, np.inf))
    assert widest([sure], [less]) == (less,) == widest([less], [sure])
    assert widest([less], [blind]) == (less,)


def test_what_they_hardly_show_is_known_as_it_was_declared():
    """To its tolerance; that the fit did not move it is no evidence."""
    replay = toy_replay("run", 1, noise=0.1)
    seen, most = replay.observed["torque"], 0.999 * replay.inputs["u"]
    replay = replace(replay, observed={"torque": replace(seen, values=seen.values - most)})
    replay.inputs["u"][:] -= most
    fit = Fitter(ToyRig(), [replay]).fit({"scale": 1.0}, iterations=2)
    ((known,), _) = estimates(ToyRig().parameters, fit, [replay])
    declared = ToyRig().parameters[0].tolerance
    # Ten blocks less one parameter; a fiftieth of what is known comes from the data.
    assert known.half_width == pytest.approx(student.ppf(0.975, 9) * declared, rel=0.02)


def test_a_channel_that_errs_as_another_does_makes_no_interval_narrower():
    replay = toy_replay("run", 1, gain=0.3)
    twice = replace(replay, observed={**replay.observed, "again": replay.observed["torque"]})
    rig = ToyRig().extended(ALONG_X)
    fit = Fitter(rig, [replay]).fit({"scale": 1.0, "gain": 0.3}, iterations=8)
    data = slice(None, -1)  # the last row is of the declared tolerance
    both = replace(
        fit,
        jacobian=np.concatenate([fit.jacobian[data], fit.jacobian]),
        residuals=np.concatenate([fit.residuals[data], fit.residuals]),
    )
    (_, one), _ = estimates(rig.parameters, fit, [replay])
    (_, other), _ = estimates(rig.parameters, both, [twice])
    # The tolerance weighs half as much beside twice the rows: next to nothing.
    assert other.half_width == pytest.approx(one.half_width, rel=1e-3)


def test_blocks_are_of_rows_that_are_compared():
    replay = toy_replay("run", 1, gain=0.3)
    seen = replay.observed["torque"]
    keep = np.arange(2000) % 10 == 0
    some = replace(replay, observed={"torque": replace(seen, keep=keep)})
    rig, start = ToyRig().extended(ALONG_X), {"scale": 1.0, "gain": 0.3}
    sparse, closed = some, _closed_up(some, keep)
    widths = []
    for run in (sparse, closed):
        fit = Fitter(rig, [run]).fit(start, iterations=8)
        widths.append(estimates(rig.parameters, fit, [run])[0][1].half_width)
    assert widths[0] == pytest.approx(widths[1], rel=1e-12)


def _closed_up(run, keep):
    """The run of the compared rows alone."""
    seen = run.observed["torque"]
    inputs = {name: values[keep] for name, values in run.inputs.items()}
    every = replace(seen, values=seen.values[keep], keep=np.ones(int(keep.sum()), bool))
    return replace(run, time=run.time[keep], inputs=inputs, observed={"torque": every})
