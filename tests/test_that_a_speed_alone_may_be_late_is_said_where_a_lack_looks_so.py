"""A speed that is late in its own way, logged alone, looks like nothing known: that is said."""

from types import SimpleNamespace

import pytest

from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.reporting.late_speed import late_speed_sentence
from simpter_hybrid.identification.tracing.verdict import Verdict

UNKNOWN, NAMED = Verdict("unknown"), Verdict("effect")


def recording(**roles):
    channels = {n: ChannelMap(n, n, "1", role) for n, role in roles.items()}
    return SimpleNamespace(channels=channels, runs=())


def test_of_a_driven_axis_with_a_speed_alone():
    seen = recording(speed="measured", drive="input")
    assert "Log the position as well" in late_speed_sentence(seen, UNKNOWN)


@pytest.mark.parametrize(
    ("roles", "verdict"),
    [
        ({"speed": "measured", "position": "measured", "drive": "input"}, UNKNOWN),
        ({"speed": "measured"}, UNKNOWN),
        ({"speed": "input", "force": "measured"}, UNKNOWN),
        ({"speed": "measured", "drive": "input"}, NAMED),
        ({"speed": "measured", "drive": "input"}, Verdict("nothing missing")),
    ],
)
def test_not_where_a_position_tells_nothing_drives_or_nothing_looks_so(roles, verdict):
    assert late_speed_sentence(recording(**roles), verdict) == ""


def test_and_where_a_late_speed_was_found_that_leaves_more():
    seen = recording(speed="measured", drive="input")
    assert late_speed_sentence(seen, NAMED, found=True)
