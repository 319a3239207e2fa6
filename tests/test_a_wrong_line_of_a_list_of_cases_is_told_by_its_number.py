"""The number is that of the line in the file: blank ones are passed over, and counted."""

import pytest

from simpter_hybrid.problems import InvalidInput, Problems
from simpter_hybrid.sweeps.design import read_cases


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("a,b\n1,2\n3\n", 3),
        ("a,b\n\n1,2\n3\n", 4),
        ("\n , \na,b\n1,\n", 4),
        ('a,b\n"1\n2",3\n4\n', 4),
    ],
)
def test_blank_lines_count(tmp_path, text, line):
    (tmp_path / "c.csv").write_text(text, encoding="utf-8")
    problems = Problems("test")
    assert read_cases(tmp_path / "c.csv", problems) is None
    with pytest.raises(InvalidInput, match=rf"--cases: line {line} has \d values or an empty one"):
        problems.raise_if_any()
