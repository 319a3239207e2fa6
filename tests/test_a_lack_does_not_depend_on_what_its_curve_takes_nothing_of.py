"""What single runs located and a curve over it denies is not what a lack is said to depend on."""

from types import SimpleNamespace as Some

import pytest

from simpter_hybrid.identification.fitting.floor import Floors
from simpter_hybrid.identification.reporting.lack_sentences import lack_sentence
from simpter_hybrid.identification.tracing.limits import REPEATED, SINGLE_AXIS
from simpter_hybrid.identification.tracing.verdict import Verdict

UNTOLD, HARDLY = "On what it depends these runs do not tell", "runs held out hardly show that"
BOTH = ("force:speed", "force:slip_velocity")


@pytest.mark.parametrize(
    ("gain", "left", "where", "limits", "told"),
    [
        (0.03, 1.96, BOTH, SINGLE_AXIS, UNTOLD),
        (0.03, 2.10, BOTH[:1], SINGLE_AXIS, UNTOLD),
        (0.10, 1.99, BOTH[:1], SINGLE_AXIS, HARDLY),
        (0.03, 1.60, BOTH[:1], SINGLE_AXIS, ": it depends on speed."),  # held out it helps
        (0.03, 1.96, ("force:speed", "force:acceleration"), SINGLE_AXIS, HARDLY),  # no curve there
        (0.03, 1.96, BOTH[:1], REPEATED, ": it depends on speed."),  # no noise goes along with it
    ],
)
def test_it_is_said_in_place_of_the_coordinate(gain, left, where, limits, told):
    search = Some(verdict=Verdict("unknown", coordinates=where), rounds=())
    found = Some(
        search=search, limits=limits, floors=Floors(1.0, 1.0, 1.0), taken_back=None,
        error_by_stage={"after": 2.0, "empirical": left},
        empirical=Some(coordinate=where[0], trial=Some(gain=gain)),
    )  # fmt: skip
    said = lack_sentence(found)
    assert told in said
    assert ("depends on speed" in said) is (told != UNTOLD)
