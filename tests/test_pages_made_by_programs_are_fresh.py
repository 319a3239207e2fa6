"""Pages of docs/ that programs beside them make are what these make today."""

import subprocess
import sys
from pathlib import Path

import pytest

DOCS = Path(__file__).parents[1] / "docs"


# Not studies_page.py: it runs every study, for minutes.  The others read the libraries and tables
# that benchmarks have left, no recordings.
@pytest.mark.parametrize("name", ["karnopp", "names", "parts", "real_data"])
def test_the_page_is_fresh(name):
    # Else run it without --check.
    ran = [sys.executable, str(DOCS / f"{name}_page.py"), "--check"]
    done = subprocess.run(ran, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


def test_every_name_in_verdicts_has_words():
    page = (DOCS / "names-in-verdicts.md").read_text(encoding="utf-8")
    rows = [line for line in page.splitlines() if line.startswith("| ")][1:]
    assert rows
    assert [row for row in rows if row.endswith("|  |")] == []
