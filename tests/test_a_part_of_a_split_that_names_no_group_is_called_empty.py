"""``report = []`` names no wrong group: it names none."""

import numpy as np
import pytest
from axis_recordings import LET_ALONE, written

from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.problems import InvalidInput

SPLIT = '[split]\nfit = ["take 0"]\nselect = ["take 1"]\nreport = []\n'
CHANNEL = '[channels.position]\ncolumn = "angle"\nunit = "rad"\nsign = 1\nrole = "measured"\n'


def test_a_part_of_a_split_that_names_no_group_is_called_empty(tmp_path):
    rows = [f"{take},{k / 100},{np.sin(k / 9):.5f}" for take in (0, 1) for k in range(60)]
    recording = written(tmp_path, ["take,s,angle", *rows], LET_ALONE + SPLIT + CHANNEL)
    with pytest.raises(InvalidInput, match=r"split\.report: missing or empty.*neither fits"):
        groups_of(recording)
