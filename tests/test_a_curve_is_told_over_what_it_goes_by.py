"""A curve for what depends on direction goes by the slip velocity, and is told over that."""

from types import SimpleNamespace as Some

import numpy as np
import pytest

from simpter_hybrid.identification.empirical_terms import goes_by, terms_over
from simpter_hybrid.identification.reporting.held_out_sentences import curve_sentence
from simpter_hybrid.identification.tracing.trace import Trace
from simpter_hybrid.plots.diagnosis import curve


@pytest.fixture
def found():
    """A diagnosis with a curve for what depends on the direction of a straight axis."""
    speed = np.linspace(-1.0, 2.0, 100)
    along = {"direction": np.sign(speed), "slip_velocity": speed}
    traces = {"force": [Trace(np.ones(100), np.ones(100), along)]}
    trial = Some(candidate=terms_over("force:direction", traces)[0])
    term = Some(
        coordinate="force:direction", trial=trial,
        model=Some(select_error=1.0), place=speed[::20], value=np.zeros(5), half_width=np.ones(5),
        drawn=lambda: (speed[::20], np.zeros(5)), recorded=lambda place: place,
    )  # fmt: skip
    device = Some(coordinate_dimensions=("length",))
    model = Some(predictor=Some(declared=Some(device=device)), effects=("one",), select_error=1.5)
    search = Some(corrected=model, refitted=model, floor=1.0, rounds=())
    return Some(
        empirical=term, search=search, limits=Some(estimated=False), floors=Some(report=1.0),
        error_by_stage={"after": 5.0, "empirical": 3.0},
    )  # fmt: skip


def test_only_direction_and_torque_are_replaced():
    assert goes_by("force:direction") == "force:slip_velocity"
    assert goes_by("friction:torque") == "friction:excitation"
    assert goes_by("force:position") == "force:position"


def test_its_sentence_says_slip_velocity(found):
    assert curve_sentence(found).startswith("An empirical curve over slip velocity lowers")


def test_its_picture_has_the_unit_of_a_speed(found):
    assert curve(found).axes[0].get_xlabel() == "slip velocity [m/s]"
