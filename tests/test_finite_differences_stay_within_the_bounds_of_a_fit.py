"""Beyond a bound a model may be none: a delay below zero, a friction that drives."""

from dataclasses import replace

import numpy as np
import pytest
from toy_rig import ALONG_X, SCALE, ToyRig, toy_replay

from simpter_hybrid.identification.fitting.alike_forms import _gain
from simpter_hybrid.identification.fitting.fit import Fitter
from simpter_hybrid.identification.fitting.fitted_model import Split, refitted
from simpter_hybrid.identification.fitting.predictor import Parameter
from simpter_hybrid.identification.fitting.survey import survey
from simpter_hybrid.identification.own_values import _own_values
from simpter_hybrid.identification.run_levels import reach

#: As long as what is typical is all that is looked for: a delay in a record of few rows.
NARROW = Parameter("gain", 0.3, 0.0, 0.5, 0.4)
ASKED: list[float] = []


class Bounded(ToyRig):
    """Remembers which gains it was asked for."""

    def predict(self, values, replays):
        ASKED.append(values.get("gain", 0.0))
        return super().predict(values, replays)


@pytest.fixture
def asked():
    ASKED.clear()
    return ASKED


RUNS = [toy_replay(f"run {k}", k, gain=0.3, noise=1.0) for k in range(2)]
BASE = refitted(Bounded(), Split(RUNS[:1], RUNS[1:], ()))
FORM = replace(ALONG_X, parameters=(NARROW,), starts=((NARROW.value,),))


@pytest.mark.parametrize(
    ("value", "size", "step"),
    [
        (0.1, 0.4, 0.4), (0.45, 0.4, -0.4),  # there is room, to the last digit
        (0.2, 0.4, 0.3), (0.3, 0.4, -0.3), (0.0, 0.7, 0.5),
    ],
)  # fmt: skip
def test_a_step_is_as_long_as_there_is_room(value, size, step):
    assert NARROW.difference(value, size) == pytest.approx(step, rel=1e-15)


def test_what_has_no_bounds_takes_the_whole_step():
    assert Parameter("gain", 0.0, -np.inf, np.inf, 1.0).difference(3.0, 2.0) == 2.0


def test_a_fit_asks_for_nothing_beyond(asked):
    fitter = Fitter(Bounded((SCALE, NARROW)), RUNS, step=2.0)
    values = {"scale": 1.0, "gain": 0.3}
    wide = fitter.jacobian(values, fitter.residuals(values))
    assert (min(asked), max(asked)) == (0.0, 0.3)
    # Linear, so a short step tells the same.
    fine = fitter.jacobian(values, fitter.residuals(values), step=0.1)
    assert wide[:, 1] == pytest.approx(fine[:, 1], abs=1e-9)


def test_a_survey_asks_for_nothing_beyond(asked):
    survey(BASE, [FORM], RUNS[:1])
    assert asked == [0.0]  # from 0.3, where the model is known


def test_a_richer_form_asks_for_nothing_beyond(asked):
    begun = replace(FORM, fitted=(("scale", 1.0), ("gain", NARROW.value)))
    _gain(BASE, begun, BASE, Split(RUNS[:1], RUNS[1:], ()))
    assert (min(asked), max(asked)) == (0.0, 0.3)


def test_own_values_of_runs_ask_for_nothing_beyond(asked):
    held = replace(NARROW, tolerance=0.1)
    model = refitted(Bounded((held,)), Split(RUNS[:1], RUNS[1:], ()))
    asked.clear()
    _own_values(model, held, RUNS, 1.0)
    least, most = reach(held)
    assert least <= min(asked) <= max(asked) <= most
