"""A record that begins with zeros shows whether it has decimal commas in a later row."""

import tomllib

import pytest

from simpter_hybrid.identification.recordings.draft_map import draft_map


@pytest.mark.parametrize("whole", [1, 200])
def test_a_draft_takes_its_decimal_sign_from_a_row_that_shows_one(tmp_path, whole):
    file = tmp_path / "rec.csv"
    rows = [f"{k};0;0" for k in range(whole)]
    rows += [f"{whole + k},5;0,{k % 7}13;{k % 5},25" for k in range(60)]
    file.write_text("\n".join(["t;x;f", *rows]))
    told = tomllib.loads(draft_map(str(file)))
    assert told["table"] == {"decimal": ","}
    assert {channel["column"] for channel in told["channels"].values()} == {"x", "f"}
