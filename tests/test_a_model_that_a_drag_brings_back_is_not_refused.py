"""A joint held at one speed hardly changes: a model that lacks its drag errs more than rest."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from toy_rig import ALONG_X, ToyRig, toy_replay

from simpter_hybrid.identification.fitting.residual import over_rest
from simpter_hybrid.identification.hopeless import HOPELESS, _eased


def held(name, seed):
    """What is measured stays at 1: along x goes what the drive does beyond that."""
    run = toy_replay(name, seed)
    (seen,) = run.observed.values()
    noise = seen.values - run.inputs["u"]
    inputs = {**run.inputs, "x": 1.0 - 2.0 * run.inputs["u"]}
    drive = {**inputs, "u": 2.0 * run.inputs["u"]}
    return replace(run, inputs=drive, observed={"torque": replace(seen, values=1.0 + noise)})


@pytest.mark.parametrize(("name", "eased"), [("viscous-drag", True), ("stribeck", False)])
def test_only_what_is_asked_first_can_bring_it_back(name, eased):
    runs = [held("one", 1), held("two", 2)]
    rig = ToyRig()
    assert over_rest(rig.predict({"scale": 1.0}, runs), runs) > HOPELESS
    bench = SimpleNamespace(predictor=rig, candidates=(replace(ALONG_X, name=name),))
    assert _eased(bench, {"scale": 1.0}, runs[:1], runs[1:]) is eased


def test_what_no_drag_brings_back_stays_hopeless():
    runs = [held("one", 1), held("two", 2)]
    still = [replace(r, inputs={**r.inputs, "x": 0.0 * r.time}) for r in runs]
    bench = SimpleNamespace(predictor=ToyRig(), candidates=(replace(ALONG_X, name="viscous-drag"),))
    assert np.isfinite(over_rest(ToyRig().predict({"scale": 1.0}, still), still))
    assert _eased(bench, {"scale": 1.0}, still[:1], still[1:]) is False


@pytest.mark.parametrize(("noise", "eased"), [(1.0, True), (0.01, False)])
def test_friction_with_which_a_model_rests_where_something_moves_is_none(noise, eased):
    # What is measured moves by a deviation: it is that of the noise, or a hundred times it.
    runs = [held("one", 1), held("two", 2)]
    runs = [
        replace(r, observed={n: replace(s, sd=noise * s.sd) for n, s in r.observed.items()})
        for r in runs
    ]
    bench = SimpleNamespace(
        predictor=ToyRig(), candidates=(replace(ALONG_X, name="friction-scale"),)
    )
    assert _eased(bench, {"scale": 1.0}, runs[:1], runs[1:]) is eased
