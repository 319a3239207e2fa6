"""A candidate that says nothing of some samples is judged, beside the base, by the others."""

import numpy as np
import pytest
from toy_rig import SCALE, ToyRig, toy_replay

from simpter_hybrid.identification.fitting.fit import Fitter
from simpter_hybrid.identification.fitting.fitted_model import Split, judged, refitted
from simpter_hybrid.identification.fitting.predictor import UNTOLD, Candidate, Parameter
from simpter_hybrid.identification.fitting.residual import rms, weighted_residuals

SILENT = Candidate("silent", (Parameter("part", 0.0, 0.0, 1.0, 0.1),), ((0.1,),), "s", "sensor", ())


class SilentRig(ToyRig):
    """Repeats what was measured in the first part of a run."""

    def predict(self, values, replays):
        found = super().predict(values, replays)
        found[UNTOLD] = []
        for replay, made in zip(replays, found["torque"], strict=True):
            untold = np.arange(made.size) < values["part"] * made.size
            made[untold] = replay.observed["torque"].values[untold]
            found[UNTOLD].append(untold)
        return found


def _bent(seed):
    """A run that begins with a transient that no candidate makes."""
    replay = toy_replay("run", seed)
    replay.observed["torque"].values[:200] += 2.0
    return replay


def _trial(part):
    split = Split([_bent(1)], [_bent(2)], [])
    base = refitted(ToyRig(), split)
    fitter = Fitter(SilentRig((SCALE, *SILENT.parameters)), split.fit)
    fit = fitter.fit({**base.values, "part": part}, iterations=0)
    return base, judged(SILENT, fitter, fit, base, split, 1.0), split


def test_silence_about_what_the_base_leaves_is_no_gain():
    base, trial, split = _trial(0.1)
    repeated = weighted_residuals(SilentRig(), {**base.values, "part": 0.1}, split.select)
    assert rms(repeated) < 0.5 * base.select_error  # ... though it looks like one
    assert trial.gain == pytest.approx(0.0, abs=1e-12)
    assert trial.share == pytest.approx(0.0, abs=1e-12)


def test_beside_other_trials_its_error_is_that_of_the_base_over_all_rows():
    base, trial, _ = _trial(0.1)
    assert trial.select_error == pytest.approx(base.select_error, rel=1e-9)


def test_its_own_error_is_that_of_what_it_tells():
    base, trial, split = _trial(0.1)
    residual = (
        split.select[0].observed["torque"].values
        - ToyRig().predict(base.values, split.select)["torque"][0]
    )
    assert trial.told_error == pytest.approx(
        np.sqrt(np.mean((residual[200:] / 0.1) ** 2)), rel=1e-9
    )


def test_what_tells_nothing_gains_nothing():
    base, trial, _ = _trial(1.0)
    assert (trial.gain, trial.share, trial.select_error) == (0.0, 0.0, base.select_error)
