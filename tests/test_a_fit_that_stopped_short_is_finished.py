"""A peak narrower than a wide step of a difference, and a plain form beside a richer one."""

from dataclasses import dataclass, replace

import numpy as np
import pytest
from toy_rig import SCALE, toy_replay

from simpter_hybrid.identification.fitting.farther import finished, simpler_from
from simpter_hybrid.identification.fitting.fit import Fit, Fitter
from simpter_hybrid.identification.fitting.fitted_model import Split, judged, refitted
from simpter_hybrid.identification.fitting.memory import Memory
from simpter_hybrid.identification.fitting.predictor import Candidate, Parameter

#: The fade's typical change is larger than the fade itself, as a Stribeck friction's may be.
PEAK = (Parameter("peak.rise", 0.0, -5.0, 5.0, 0.05), Parameter("peak.fade", 0.1, 0.005, 2.0, 0.2))
RICH = (
    Parameter("rich.1.rise", 0.0, -5.0, 5.0, 0.05), Parameter("rich.1.fade", 0.1, 0.005, 2.0, 0.2),
    Parameter("rich.2.slope", 0.0, -5.0, 5.0, 0.05),
)  # fmt: skip
TRUE = {"scale": 1.0, "peak.rise": 0.8, "peak.fade": 0.05}


def _candidate(name, parameters):
    start = tuple(0.1 for _ in parameters)
    return Candidate(name, parameters, (start,), "velocity", "friction", ("friction:x",))


@dataclass(frozen=True)
class Peaked:
    """torque = scale u + rise exp(-|x| / fade) + slope y."""

    parameters: tuple[Parameter, ...] = (SCALE,)

    def extended(self, candidate):
        return Peaked((*self.parameters, *candidate.parameters))

    def predict(self, values, replays):
        def of(r):
            rise = values.get("peak.rise", values.get("rich.1.rise", 0.0))
            fade = values.get("peak.fade", values.get("rich.1.fade", 1.0))
            slope = values.get("rich.2.slope", values.get("rich.2.rise", 0.0))
            peak = rise * np.exp(-np.abs(r.inputs["x"]) / fade)
            return values["scale"] * r.inputs["u"] + peak + slope * r.inputs["y"]

        return {"torque": [of(r) for r in replays]}


def _run(seed, noise=0.01):
    run = toy_replay("run", seed, noise=noise, experiment="abc"[seed % 3])
    peak = 0.8 * np.exp(-np.abs(run.inputs["x"]) / 0.05)
    run.observed["torque"].values[:] += peak
    return run


SPLIT = Split([_run(1), _run(2)], [_run(4)], [])
BASE = refitted(Peaked(), SPLIT)


def _trial(candidate, values):
    fitter = Fitter(BASE.predictor.extended(candidate), SPLIT.fit)
    at = fitter.residuals(values)
    fit = Fit(dict(values), float(at @ at), fitter.jacobian(values, at), at)
    return judged(candidate, fitter, fit, BASE, SPLIT, 1.0)


SHORT = _trial(_candidate("peak", PEAK), {"scale": 1.0, "peak.rise": 0.7, "peak.fade": 0.06})


def test_with_narrow_steps_it_ends_at_the_noise():
    done = finished(BASE, SHORT, SPLIT, 1.0)
    assert done.select_error < 1.03 < SHORT.select_error
    # Some hundred rows hold the peak: noise of a hundredth tells its height to a thousandth.
    assert done.fit.values["peak.rise"] == pytest.approx(0.8, abs=0.01)
    assert done.fit.values["peak.fade"] == pytest.approx(0.05, abs=0.001)


def test_what_it_hands_on_are_columns_of_usual_steps():
    done = finished(BASE, SHORT, SPLIT, 1.0)
    usual = Fitter(BASE.predictor.extended(done.candidate), SPLIT.fit)
    right = usual.jacobian(done.fit.values, done.fit.residuals)
    assert np.array_equal(done.fit.jacobian, right)


def test_what_is_at_its_end_stays():
    done = finished(BASE, SHORT, SPLIT, 1.0)
    assert finished(BASE, done, SPLIT, 1.0) is done


def test_a_plain_form_begins_where_a_richer_one_ended():
    stuck = _trial(SHORT.candidate, {"scale": 1.0, "peak.rise": 0.1, "peak.fade": 1.9})
    rich = _candidate("rich", RICH)
    ended = _trial(rich, {"scale": 1.0, "rich.1.rise": 0.79, "rich.1.fade": 0.051,
                          "rich.2.slope": 0.0})  # fmt: skip
    found = {t.candidate.name: t for t in simpler_from(BASE, [stuck, ended], ended, SPLIT, 1.0)}
    assert found["peak"].select_error < 1.03
    assert found["rich"] is ended


def test_of_two_parts_with_numbers_of_one_name_the_first_is_the_plain_form():
    stuck = _trial(SHORT.candidate, {"scale": 1.0, "peak.rise": 0.1, "peak.fade": 1.9})
    twice = (*RICH[:2], replace(RICH[2], name="rich.2.rise"))
    values = {"scale": 1.0, "rich.1.rise": 0.79, "rich.1.fade": 0.051, "rich.2.rise": 0.0}
    ended = _trial(replace(_candidate("rich", twice), simpler="peak"), values)
    found = {t.candidate.name: t for t in simpler_from(BASE, [stuck, ended], ended, SPLIT, 1.0)}
    assert found["peak"].select_error < 1.03
    # Of a form for each of several places the first is no plain one.
    ended = replace(ended, candidate=replace(ended.candidate, simpler=""))
    (left, _) = simpler_from(BASE, [stuck, ended], ended, SPLIT, 1.0)[::-1]
    assert left is stuck


def test_one_that_acts_at_fewer_places_is_another_trial():
    rich = _candidate("rich", RICH)
    values = {"scale": 1.0, "rich.1.rise": 0.79, "rich.1.fade": 0.051, "rich.2.slope": 0.0}
    ended, memory = _trial(rich, values), Memory()
    wide = _trial(SHORT.candidate, {"scale": 1.0, "peak.rise": 0.1, "peak.fade": 1.9})
    narrow = _trial(replace(SHORT.candidate, parameters=PEAK[:1], starts=((0.1,),)),
                    {"scale": 1.0, "peak.rise": 0.1})  # fmt: skip
    for stuck in (wide, narrow, wide):
        (trial,) = (
            t
            for t in simpler_from(BASE, [stuck, ended], ended, SPLIT, 1.0, memory=memory)
            if t.candidate.name == "peak"
        )
        names = {p.name for p in trial.candidate.parameters}
        assert names | {"scale"} == set(trial.fit.values)
        assert trial.fit.jacobian.shape[1] == len(trial.fit.values)
