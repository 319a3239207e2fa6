import pytest

from simpter_hybrid.identification.recordings.layout import Layout


@pytest.mark.parametrize("layout", [Layout(), Layout(decimal=",")], ids=["point", "comma"])
def test_a_cell_with_a_line_among_its_digits_is_no_number(layout: Layout) -> None:
    assert layout.number("1000") == 1000.0
    with pytest.raises(ValueError, match="a line among digits"):
        layout.number("1_000")
