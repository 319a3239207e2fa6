"""A ratio of runs none of which reached its end is null in the numbers of a study, not NaN."""

import json

from simpter_hybrid.studies.page import write_pages
from simpter_hybrid.studies.study import Study


def test_numbers_of_studies_are_json_where_none_can_be_told(tmp_path):
    made = Study("Why?", "6.3", "so", (), ("f",), {"ratios": {"P, a": [float("nan"), 1.5]}})
    write_pages({"delrin": made}, tmp_path, 3)
    text = (tmp_path / "numbers.json").read_text(encoding="utf-8")
    assert "NaN" not in text
    assert json.loads(text) == {"delrin": {"ratios": {"P, a": [None, 1.5]}}}
