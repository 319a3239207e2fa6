"""A1-A47 and S1-S73: each is compared, or built and tested, or says why it cannot be compared."""

import ast
import re
from pathlib import Path

import pytest

import simpter_hybrid.reproduce as package
from simpter_hybrid.reproduce.checklist import CLAIMS, ENTRIES, SYSTEMS
from simpter_hybrid.reproduce.registry import ALIASES, REPRODUCTIONS

FOLDER = Path(package.__file__).parent
ROOT = FOLDER.parent.parent


def items_of(comparison: str) -> set[str]:
    """Numbers that occur in the text constants of a comparison's module."""
    source = (FOLDER / (REPRODUCTIONS[comparison][0].split(".")[0] + ".py")).read_text()
    texts = [
        node.value
        for node in ast.walk(ast.parse(source))
        if isinstance(node, ast.Constant) and isinstance(node.value, str)
    ]
    return {word for text in texts if re.fullmatch(r"([AS]\d+ ?)+", text) for word in text.split()}


def test_no_entry_is_missing():
    assert list(CLAIMS) == [f"A{k}" for k in range(1, 48)]
    assert list(SYSTEMS) == [f"S{k}" for k in range(1, 74)]


@pytest.mark.parametrize("number", ENTRIES)
def test_the_entry_leads_somewhere(number):
    entry = ENTRIES[number]
    assert entry.comparisons or entry.files or entry.why
    for name in entry.comparisons:
        assert number in items_of(name), f"{name} has no row for {number}"
    for file in entry.files:
        assert (ROOT / file).is_file()


def test_every_row_belongs_to_an_entry():
    for name in REPRODUCTIONS:
        assert items_of(name) <= set(ENTRIES)


def test_figures_and_tables_lead_to_comparisons():
    assert set(ALIASES.values()) <= set(REPRODUCTIONS)
