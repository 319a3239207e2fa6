"""One file: no address, no file beside it, text of the user escaped; the same bytes twice."""

import re

import pytest
from sampled_runs import oscillator

from simpter_hybrid.report.page import report_html

TEXT = "name = '<b>&'  # </script>\n"


@pytest.fixture(scope="module")
def page() -> str:
    return report_html(oscillator(), TEXT)


def test_a_report_refers_to_nothing_outside_itself(page):
    assert "://" not in page
    references = re.findall(r"""(?:src|href)\s*=\s*["']([^"']*)""", page)
    assert references
    assert all(reference.startswith("data:") for reference in references)
    assert "url(" not in page
    assert "@import" not in page


def test_what_the_user_wrote_is_escaped(page):
    assert "&lt;b&gt;&amp;" in page
    assert page.count("</script>") == 2


def test_a_report_has_the_same_bytes_twice(page):
    assert report_html(oscillator(), TEXT) == page
