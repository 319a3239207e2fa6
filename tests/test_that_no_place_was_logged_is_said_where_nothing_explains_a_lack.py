from types import SimpleNamespace

import pytest

from simpter_hybrid.identification.reporting.cautions import no_place_sentence
from simpter_hybrid.identification.tracing.verdict import Verdict

UNKNOWN = Verdict("unknown")


def recording(*names):
    return SimpleNamespace(channels=dict.fromkeys(names))


def test_of_a_speed_alone():
    assert "Log the position" in no_place_sentence(recording("speed", "current"), UNKNOWN)


@pytest.mark.parametrize(
    ("names", "verdict"),
    [
        (("speed", "position"), UNKNOWN),
        (("position_1", "position_2"), UNKNOWN),
        (("speed",), Verdict("unknown", coordinates=("force:slip_velocity",))),
        (("speed",), Verdict("nothing missing")),
    ],
)
def test_not_where_one_was_or_something_else_tells(names, verdict):
    assert no_place_sentence(recording(*names), verdict) == ""
