"""docs/devices-and-effects.md has every device and every effect that a file may name."""

from pathlib import Path

import pytest

from simpter_hybrid.reading.kinds import shipped

PAGE = Path(__file__).resolve().parent.parent / "docs" / "devices-and-effects.md"


@pytest.mark.parametrize("kind", [*shipped("device"), *shipped("effect")])
def test_the_page_names_it(kind):
    # Else run: python docs/parts_page.py
    assert f"**{kind}**" in PAGE.read_text(encoding="utf-8")
