"""A dependence by chance is no lack, and no curve makes it look like one."""

from types import SimpleNamespace as Named

import numpy as np
import pytest

from simpter_hybrid.identification.tracing.signature import Dependence
from simpter_hybrid.plots.diagnosis import dependence


def _found(kind, balance, along="speed", gain=0.004, empirical=None):
    course = np.linspace(1.0, 30.0, 12)
    seen = Dependence(along, gain, 0.005, 100, course, np.sin(course), 0.1 * np.cos(course))
    none = {"verdict": Named(accepted=None), "logged": {}}
    rounds = (Named(before={balance: (seen,)}, after={balance: ()}, **none),)
    declared = Named(declared=Named(device=Named(coordinate_dimensions=("angle",))))
    model, verdict = Named(predictor=declared), Named(kind=kind)
    diagnosis = Named(rounds=rounds, declared=model, verdict=verdict)
    return Named(diagnosis=diagnosis, empirical=empirical)


def test_nothing_is_drawn_where_nothing_is_missing():
    assert dependence(_found("nothing missing", "friction")) is None


@pytest.mark.parametrize("balance", ["friction", "load"])
def test_the_band_of_a_lack_is_said_to_be_no_uncertainty(balance):
    (legend,) = dependence(_found("unknown", balance)).legends
    assert any("no uncertainty" in text.get_text() for text in legend.get_texts())


def test_what_rings_is_drawn_all_the_same():
    assert dependence(_found("nothing missing", "ringing", "breakaway", 0.9)) is not None


def test_what_does_not_count_is_not_drawn_beside_a_curve_that_tells_it():
    assert dependence(_found("unknown", "friction")) is not None
    assert dependence(_found("unknown", "friction", empirical=Named())) is None
