"""A name of a run may hold what matplotlib takes for the beginning of mathematics."""

import pytest

from simpter_hybrid.plots.style import figure, png


@pytest.mark.parametrize("name", ["5_{ $a_{$", "$x^2$ and $1"])
def test_a_title_with_dollars_is_drawn(name):
    assert png(figure(1.0, name)).startswith(b"\x89PNG")


def test_it_is_no_mathematics():
    one, other = (png(figure(1.0, name)) for name in ("$a$", "a"))
    assert one != other


def test_powers_of_ten_on_an_axis_still_are():
    picture = figure(2.0, "$")
    axis = picture.add_subplot()
    axis.set_yscale("log")
    axis.set_ylim(1e-7, 1e3)
    png(picture)
    labels = [text for text in axis.get_yticklabels() if "mathdefault" in text.get_text()]
    assert labels
    assert all(text.get_parse_math() for text in labels)
