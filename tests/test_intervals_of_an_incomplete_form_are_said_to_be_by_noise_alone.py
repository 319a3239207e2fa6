"""A search that found a law incomplete does not print its intervals as if the law were right."""

import pytest

from simpter_hybrid.identification.reporting import page

ONE = {
    "name": "stribeck.rise", "value": 0.9, "half_width": 0.1, "unit": "", "found": True,
    "largest_correlation": 0.0, "with": "",
}  # fmt: skip


@pytest.mark.parametrize(
    ("verdict", "words"),
    [("effect", "if the laws are right"), ("form incomplete", "by noise alone: a form is")],
)
def test_the_sentence_and_the_table_say_what_an_interval_knows_of(verdict, words):
    meant = page._meant(verdict)
    assert words in page._fitted([ONE], meant)
    assert words in page._parameters([ONE], meant)
