"""One linear step against the closed form of a regression on two columns; thinning out."""

from dataclasses import replace

import numpy as np
import pytest
from toy_rig import ALONG_X, ALONG_Y, ToyRig, toy_replay

from simpter_hybrid.identification.fitting.fitted_model import Split, refitted
from simpter_hybrid.identification.fitting.survey import LARGEST, linear_step, survey, worth_fitting


def test_the_gain_is_that_of_the_partial_regression():
    generator = np.random.default_rng(5)
    base, own, residual = generator.standard_normal((3, 400))
    beyond = own - base * (base @ own) / (base @ base)
    gain, step, along = linear_step(residual, [base], own[:, None])
    slope = beyond @ residual
    assert step == pytest.approx([-slope / (beyond @ beyond)], rel=1e-9)
    assert gain == pytest.approx(slope**2 / (beyond @ beyond) / (residual @ residual), rel=1e-9)
    together = np.linalg.lstsq(np.column_stack([base, own]), -residual, rcond=None)[0]
    assert [*along, *step] == pytest.approx(together, rel=1e-9)


def test_a_column_that_changes_nothing_promises_nothing():
    gain, step, _ = linear_step(np.ones(10), [], np.zeros((10, 1)))
    assert gain == 0.0
    assert step == pytest.approx([0.0])


@pytest.mark.parametrize(("true", "begun"), [(0.4, 0.4), (0.9, LARGEST * 0.1)])
def test_the_effect_that_is_missing_comes_first_at_the_size_asked_for(true, begun):
    replay = toy_replay("run", 1, scale=1.1, gain=true)
    base = refitted(ToyRig(), Split([replay], [toy_replay("other", 2, 1.1, true)], []))
    sized = replace(ALONG_X, sizes=("gain",))
    kept = worth_fitting(survey(base, [ALONG_Y, sized], [replay]), ())
    assert [p.candidate.name for p in kept] == ["along x", "along y"]
    # The model is linear: the scaled start is the optimum, but for the scale's tolerance and five
    # standard errors of 0.1 / sqrt(1000) = 0.003; beyond LARGEST it is the second choice.
    capped, whole = kept[0].scaled
    assert capped["gain"] == pytest.approx(begun, abs=0.015)
    assert whole["gain"] == pytest.approx(true, abs=0.015)


def test_of_several_sizes_each_is_begun_at_its_own():
    replay = toy_replay("run", 1, gain=0.4)
    base = refitted(ToyRig(), Split([replay], [toy_replay("other", 2, gain=0.4)], []))
    both = replace(
        ALONG_X,
        parameters=(*ALONG_X.parameters, *ALONG_Y.parameters),
        starts=((0.1, 0.1),),
        sizes=("gain", "other"),
    )
    (probe,) = survey(base, [both], [replay])
    assert probe.scaled[0]["gain"] == pytest.approx(0.4, abs=0.015)
    assert probe.scaled[0]["other"] == pytest.approx(0.0, abs=0.015)


def test_a_number_at_its_bound_takes_nothing_away_beforehand():
    replay = toy_replay("run", 1, scale=2.0)  # the fit may go to 1.5
    replay.inputs["x"][:] = replay.inputs["u"]
    base = refitted(ToyRig(), Split([replay], [replay], []))
    assert base.values["scale"] == 1.5
    (probe,) = survey(base, [ALONG_X], [replay])
    assert probe.gain > 0.95  # of 0.5 rms and more only 0.1 of noise is left
