"""docs/names-in-verdicts.md lists what a diagnosis tries, each name with words for it."""

import subprocess
import sys
from pathlib import Path

DOCS = Path(__file__).parents[1] / "docs"


def test_the_page_is_what_the_libraries_say():
    # Else run: python docs/names_page.py
    ran = [sys.executable, str(DOCS / "names_page.py"), "--check"]
    assert subprocess.run(ran, capture_output=True, text=True).stdout == "fresh\n"


def test_every_name_has_words():
    page = (DOCS / "names-in-verdicts.md").read_text(encoding="utf-8")
    rows = [line for line in page.splitlines() if line.startswith("| ")][1:]
    assert rows
    assert [row for row in rows if row.endswith("|  |")] == []
