"""The hand of the tests on the assembled robot turns one of two links and holds the other."""

import pytest

from simpter_hybrid.checks.validation import validate
from simpter_hybrid.controllers.hand import HandAtTip
from simpter_hybrid.devices.extended import with_shaft
from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.problems import InvalidInput

LINE = load("line-y24")
STAGE = ((HandAtTip(0.5, 10.0, 5.0), 1),)


def test_a_third_coordinate_is_refused_by_the_name_of_the_stage():
    geared = LINE.replace(
        device=with_shaft(LINE.device, 0, 2.0, 0.01), q=(*LINE.q, 0.0), qd=(*LINE.qd, 0.0)
    )
    with pytest.raises(InvalidInput, match="HandAtTip is for devices of 2 coordinates, got"):
        validate(geared.replace(controllers=STAGE))


def test_two_links_are_what_it_is_for():
    validate(LINE.replace(controllers=STAGE))
