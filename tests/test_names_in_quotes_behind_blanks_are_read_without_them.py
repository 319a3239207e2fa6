"""``"s", "x"`` names the same columns as ``"s","x"``, and so with semicolons."""

import pytest

from simpter_hybrid.identification.recordings.text_rows import cells_of


@pytest.mark.parametrize("mark", [",", ";"])
def test_names_in_quotes_behind_blanks_are_read_without_them(mark):
    assert cells_of(f'"s"{mark} "a{mark}x"{mark} "u"', mark) == ["s", f"a{mark}x", "u"]
