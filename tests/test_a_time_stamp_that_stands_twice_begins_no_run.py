"""The draft of a map tells where the time begins anew: not where one stamp was written twice."""

import numpy as np

from simpter_hybrid.identification.recordings.draft_map import draft_map


def test_a_time_stamp_that_stands_twice_begins_no_run(tmp_path):
    time = np.arange(0.0, 1.0, 0.01)
    time[50] = time[49]
    rows = (f"{t:.2f},{np.sin(7.0 * t):.4f}" for t in time)
    (tmp_path / "data.csv").write_text("\n".join(["t,force", *rows]), encoding="utf-8")
    text = draft_map(str(tmp_path / "data.csv"))
    assert 'column = "t"' in text
    assert "begins anew" not in text
