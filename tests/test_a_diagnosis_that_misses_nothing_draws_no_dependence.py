"""A dependence by chance is no lack, and no curve makes it look like one."""

from types import SimpleNamespace as Named

import numpy as np
import pytest

from simpter_hybrid.identification.tracing.signature import Dependence
from simpter_hybrid.plots.diagnosis import dependence


def _found(kind, balance, along="speed", gain=0.004, empirical=None, band=None):
    course = np.linspace(1.0, 30.0, 12)
    curve = course, np.sin(course), 0.1 * np.cos(course)
    seen = Dependence(along, gain, 0.005, 100, *curve, band=band)
    none = {"verdict": Named(accepted=None), "logged": {}}
    rounds = (Named(before={balance: (seen,)}, after={balance: ()}, **none),)
    declared = Named(declared=Named(device=Named(coordinate_dimensions=("angle",))))
    model, verdict = Named(predictor=declared), Named(kind=kind)
    diagnosis = Named(rounds=rounds, refitted=model, verdict=verdict)
    return Named(search=diagnosis, empirical=empirical)


def test_nothing_is_drawn_where_nothing_is_missing():
    assert dependence(_found("nothing missing", "friction")) is None


@pytest.mark.parametrize("balance", ["friction", "load"])
@pytest.mark.parametrize(("band", "banded"), [(np.full(12, 0.1), True), (None, False)])
def test_the_band_of_a_lack_is_its_uncertainty_if_that_is_known(balance, band, banded):
    (legend,) = dependence(_found("unknown", balance, band=band)).legends
    assert any("95 %" in text.get_text() for text in legend.get_texts()) == banded


def test_what_rings_is_drawn_all_the_same():
    assert dependence(_found("nothing missing", "ringing", "breakaway", 0.9)) is not None


def test_what_does_not_count_is_not_drawn_beside_a_curve_that_tells_it():
    assert dependence(_found("unknown", "friction")) is not None
    assert dependence(_found("unknown", "friction", empirical=Named())) is None
