"""``1_0`` is a slip of the hand, or one of a name: nobody measured ten."""

import pytest

from simpter_hybrid.reading.series import Column, SeriesError, read_columns


def test_a_line_among_digits_makes_a_cell_no_number(tmp_path):
    file = tmp_path / "pull.csv"
    file.write_text("t,F\n0,1_0\n1,25\n")
    with pytest.raises(SeriesError) as wrong:
        read_columns(file, [Column("t", "s", "time"), Column("F", "N", "force")])
    (found,) = wrong.value.found
    assert found[1:3] == ("column F: no number", "1_0")
