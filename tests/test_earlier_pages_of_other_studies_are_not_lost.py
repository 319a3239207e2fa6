"""``study`` and ``reproduce`` refuse a directory with pages that they do not make anew."""

import pytest

from simpter_hybrid.cli import main
from simpter_hybrid.commands.out_directory import check_out
from simpter_hybrid.problems import InvalidInput


@pytest.mark.parametrize(
    ("command", "mark", "asked", "earlier"),
    [
        ("study", "numbers.json", "delrin", "supply"),
        ("reproduce", "rows.json", "figure-50", "calibration"),
    ],
)
def test_what_would_be_lost_is_told_before_the_work(
    tmp_path, capsys, command, mark, asked, earlier
):
    (tmp_path / mark).write_text(f'{{"{earlier}": []}}')
    assert main([command, asked, "--out", str(tmp_path)]) == 2
    said = capsys.readouterr()
    assert f"--out: holds pages of {earlier}, which would be lost" in said.err
    assert f"all to be made anew: {earlier} " in said.err
    assert said.out == ""


def test_pages_of_the_same_names_are_replaced(tmp_path):
    (tmp_path / "numbers.json").write_text('{"supply": {}}')
    check_out(str(tmp_path), "numbers.json", ["supply", "delrin"])


@pytest.mark.parametrize("text", ["{", "[]"])
def test_a_mark_that_cannot_be_read_is_kept(tmp_path, text):
    (tmp_path / "numbers.json").write_text(text)
    with pytest.raises(InvalidInput, match=r"numbers\.json that cannot be read"):
        check_out(str(tmp_path), "numbers.json", ["supply"])
