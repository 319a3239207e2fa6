"""Gauss-Newton on a linear model ends where the normal equations say."""

import numpy as np
import pytest
from toy_rig import ALONG_X, SCALE, ToyRig, toy_replay

from simpter_hybrid.identification.fitting.fit import Fitter, bounded_step
from simpter_hybrid.identification.fitting.fitted_model import Split, refitted
from simpter_hybrid.identification.fitting.predictor import Parameter
from simpter_hybrid.identification.fitting.search import try_candidates


def _closed_form(replay):
    """Least squares with the declared tolerance of the scale as one more row."""
    noise = replay.observed["torque"].sd
    columns = np.column_stack([replay.inputs["u"], replay.inputs["x"]]) / noise
    target = replay.observed["torque"].values / noise
    columns = np.vstack([columns, [1 / SCALE.tolerance, 0.0]])
    return np.linalg.lstsq(columns, np.append(target, SCALE.value / SCALE.tolerance), rcond=None)[0]


def test_from_a_distant_start():
    replay = toy_replay("run", 1, scale=1.2, gain=0.7)
    rig = ToyRig().extended(ALONG_X)
    fit = Fitter(rig, [replay]).fit({"scale": 1.0, "gain": 0.0}, iterations=20, enough=1e-12)
    # Three digits below one standard deviation (0.1 / sqrt(2000) = 0.002) of the estimates.
    assert [fit.values["scale"], fit.values["gain"]] == pytest.approx(
        _closed_form(replay), abs=2e-6
    )


def test_with_reused_columns():
    replay = toy_replay("run", 1, scale=1.2, gain=0.7)
    base = refitted(ToyRig(), Split([replay], [toy_replay("other", 2, 1.2, 0.7)], []))
    fitter = Fitter(ToyRig().extended(ALONG_X), [replay], base.columns)
    fit = fitter.fit({**base.values, "gain": 0.0}, iterations=20, enough=1e-9)
    # A hundredth of a standard error (0.1 / sqrt(2000) = 0.002).
    found = [fit.values["scale"], fit.values["gain"]]
    assert found == pytest.approx(_closed_form(replay), abs=2e-5)


def test_a_trial_of_the_search_ends_a_quarter_of_a_standard_error_away_at_most():
    replay = toy_replay("run", 1, scale=1.2, gain=0.7)
    split = Split([replay], [toy_replay("other", 2, 1.2, 0.7)], [])
    trial = try_candidates(refitted(ToyRig(), split), [ALONG_X], split, floor=1.0)[0]
    # It spares steps that promise less than 3e-5 of the sum of squares (2000).
    found = [trial.fit.values["scale"], trial.fit.values["gain"]]
    assert found == pytest.approx(_closed_form(replay), abs=5e-4)


def test_a_parameter_that_pushes_against_its_bound_stays_there_and_the_others_move():
    parameters = [Parameter("a", 1.0, 0.0, 1.0, 1.0), Parameter("b", 0.0, -9.0, 9.0, 1.0)]
    columns = np.array([[1.0, 0.5], [0.5, 1.0]])
    residuals = np.array([-3.0, -1.0])  # the free optimum has a = 10/3 + 1, beyond its bound
    moved = bounded_step(parameters, {"a": 1.0, "b": 0.0}, columns, residuals, 0.0)
    assert moved["a"] == 1.0
    # With a held, b minimizes |0.5 b - 3|^2 + |b - 1|^2.
    assert moved["b"] == pytest.approx(2.0, rel=1e-6)
