"""A dimension that no file's unit could fit is told where a class is defined."""

import pytest

from simpter_hybrid.part import parameter, rows


@pytest.mark.parametrize("made", [lambda d: parameter(d, 0.1), lambda d: rows(("size", d))])
def test_it_names_the_word_that_is_none(made):
    for known in ("torque/voltage^2", "coordinate drag", "1/s", "dimensionless"):
        made(known)
    with pytest.raises(ValueError, match="no dimension 'furlong'"):
        made("torque/furlong")
