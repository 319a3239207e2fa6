"""Loggers write what they know of a file above its names: ``Interval,0.001`` is no row."""

import tomllib

from simpter_hybrid.identification.recordings.draft_map import draft_map

ABOVE = """Timestamp,2020-03-16 17:04:51,Timestamp,2020-03-16 17:04:51
Interval,0.001,Interval,0.001
Channel name,"Force",Channel name,"Input 1"
Unit,"V",Unit,"V"
"""


def test_lines_about_a_file_above_its_numbers_are_no_rows_of_a_draft(tmp_path):
    file = tmp_path / "rec.csv"
    rows = (f"{k / 1000},{k % 7 - 0.13},{k / 1000},{k % 5 - 3.2}" for k in range(60))
    file.write_text(ABOVE + "\n".join(rows))
    text = draft_map(str(file))
    told = tomllib.loads(text)
    assert told["table"] == {"rows": 5, "columns": ["c1", "Force", "c3", "Input 1"]}
    assert "these rise throughout: c1, c3" in text
