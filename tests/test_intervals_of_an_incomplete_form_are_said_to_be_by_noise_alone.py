"""A search that found a law incomplete does not print its intervals as if the law were right."""

import pytest

from simpter_hybrid.identification.reporting import page
from simpter_hybrid.identification.reporting.meaning import INCOMPLETE, OR_NOISE

ONE = {
    "name": "stribeck.rise", "value": 0.9, "half_width": 0.1, "unit": "", "found": True,
    "largest_correlation": 0.0, "with": "",
}  # fmt: skip


@pytest.mark.parametrize(
    ("verdict", "sentence", "words"),
    [
        ("effect", "with it the error is", "if the laws are right"),
        ("form incomplete", "or its form is another one", "by noise alone: a form is"),
        ("cannot be told apart", f"its form{INCOMPLETE} (", "by noise alone: a form is"),
        ("form incomplete", f"its form{OR_NOISE} (", "incomplete, or there is more noise"),
        ("cannot be told apart", f"its form{OR_NOISE} (", "incomplete, or there is more noise"),
    ],
)
def test_the_sentence_and_the_table_say_what_an_interval_knows_of(verdict, sentence, words):
    meant = page._meant({"verdict": verdict, "sentence": sentence})
    assert words in page._fitted([ONE], meant)
    assert words in page._parameters([ONE], meant)
