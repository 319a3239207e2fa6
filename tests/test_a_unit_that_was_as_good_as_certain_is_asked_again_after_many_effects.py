"""Several effects together may stand for a wrong unit, and end at the floor."""

import pytest

from simpter_hybrid.identification.doubted_channels import Doubt
from simpter_hybrid.identification.doubted_first import still_doubted
from simpter_hybrid.identification.doubted_readings import Judged
from simpter_hybrid.identification.map_changes import Times

#: Of what the refitted model left, nothing but noise is left.
EXPLAINED = Judged("select", (), before=600.0, after=1.0, floor=1.0)
#: Much is left.
BARELY = Judged("select", (), before=600.0, after=60.0, floor=1.0)


@pytest.mark.parametrize(
    ("left", "judged", "effects", "asked"),
    [
        (0.04, EXPLAINED, 2, True),
        (0.04, EXPLAINED, 1, False),
        (0.06, EXPLAINED, 2, False),
        (0.06, BARELY, 1, True),
        (0.11, BARELY, 2, False),
    ],
)
def test_it_is_asked_again(left, judged, effects, asked):
    doubt = Doubt(Times(("position",), 0.1), left)
    assert still_doubted([doubt], [judged], effects) == ((doubt,) if asked else ())
