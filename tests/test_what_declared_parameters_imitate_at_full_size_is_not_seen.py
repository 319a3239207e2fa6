from dataclasses import replace

import numpy as np
from toy_rig import ALONG_X, ALONG_Y, ToyRig, toy_replay

from simpter_hybrid.identification.effect_signals import Imitation
from simpter_hybrid.identification.fitting.fit import Fitter
from simpter_hybrid.identification.fitting.identifiability import (
    VISIBLE,
    least_visible,
    visibility,
)
from simpter_hybrid.identification.fitting.residual import weighted_residuals
from simpter_hybrid.identification.recordings.projection import beyond

VALUES = {"scale": 1.0}


def _asked(candidate, size, unit=1.0):
    """What an effect of 5 to 15 noise deviations does, some of it clipped; `y` is `u` itself."""
    rig, replay = ToyRig(), toy_replay("run", 1, noise=0.04)
    runs = [replace(replay, inputs={**replay.inputs, "y": replay.inputs["u"]})]
    at = weighted_residuals(rig, VALUES, runs)
    own = {candidate.parameters[0].name: size}
    change = weighted_residuals(rig.extended(candidate), {**VALUES, **own}, runs) - at
    columns = Fitter(rig, runs).jacobian(VALUES, Fitter(rig, runs).residuals(VALUES))[: at.size]
    least = unit * least_visible(at.size)
    return change, columns, Imitation(rig, VALUES, runs, at, columns, least)


def test_a_scale_of_the_declared_force_by_another_name_goes_unseen():
    change, columns, imitation = _asked(ALONG_Y, 0.4)
    assert visibility(beyond(change, columns)) > VISIBLE
    assert visibility(imitation.left_of(change)) < VISIBLE


def test_what_no_value_imitates_is_left_as_the_linear_step_leaves_it():
    change, columns, imitation = _asked(ALONG_X, 0.4)
    assert np.array_equal(imitation.left_of(change), beyond(change, columns))


def test_what_is_hidden_in_the_unit_of_the_residuals_is_not_looked_for():
    change, columns, imitation = _asked(ALONG_Y, 0.4, unit=1e3)
    assert np.array_equal(imitation.left_of(change), beyond(change, columns))
    assert not np.array_equal(_asked(ALONG_Y, 0.4)[2].left_of(change), beyond(change, columns))
