"""Behind a gap readings come at other rows than before it: each stretch tells of itself."""

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.between_readings import made_up_rows
from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.recorded_run import RecordedRun

TIME = 0.005 * np.arange(2000)
READ = np.sin(3 * TIME) + 0.02 * np.random.default_rng(1).standard_normal(TIME.size)
MAP = {"speed": ChannelMap("speed", "v", "rad/s", "measured")}


def _told(values, lost):
    kept = np.ones(TIME.size, bool)
    kept[1000 : 1000 + lost] = False
    seen = {"speed": values[kept]}
    run = RecordedRun("run", "", "", (0, int(kept.sum())), TIME[kept], seen)
    return [finding.value for finding in made_up_rows([run], MAP)]


@pytest.mark.parametrize("lost", [0, 16, 19, 301])
def test_whatever_number_of_rows_is_missing(lost):
    assert _told(np.interp(TIME, TIME[::8], READ[::8]), lost) == ["7 of 8 rows"]
    assert _told(READ, lost) == []
