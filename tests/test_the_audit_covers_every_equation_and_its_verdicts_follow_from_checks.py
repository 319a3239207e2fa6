"""The audit is complete, committed as computed, and a verdict cannot be typed in."""

import pytest

from derivations.audit import report
from derivations.audit.verdict import (
    AGREES,
    CONDITIONAL,
    CONTRADICTED,
    DAMAGED,
    MISPRINTED,
    OPEN,
    Entry,
    assess,
)

ENTRIES = report.all_entries()


def yes():
    return True


def no():
    return False


def test_every_equation_from_1_to_77_appears_once():
    numbers = [int(entry.number) for entry in ENTRIES if entry.number.isdigit()]
    assert numbers == list(range(1, 78))


def test_labels_are_unique():
    labels = [entry.number for entry in ENTRIES]
    assert len(set(labels)) == len(labels)


@pytest.mark.parametrize("entry", ENTRIES, ids=lambda entry: entry.number)
def test_only_the_last_reading_holds(entry):
    """Earlier readings fail, so the check is able to fail and the reading given is needed."""
    assessment = assess(entry)
    assert assessment.verdict != OPEN
    held = [outcome for _, outcome in assessment.outcomes]
    assert not any(held[:-1])
    assert held[-1] or assessment.verdict == CONTRADICTED


def test_the_committed_table_is_the_computed_one():
    assert report.PATH.read_text(encoding="utf-8") == report.text()


@pytest.mark.parametrize(
    ("readings", "verdict"),
    [
        ({"literal": yes}, AGREES),
        ({"literal": no, "lost": "dots", "restored": yes}, DAMAGED),
        ({"literal": no, "condition": "c", "conditional": yes}, CONDITIONAL),
        ({"literal": no, "corrected": "f", "correction": yes}, MISPRINTED),
        ({"literal": no, "fault": CONTRADICTED}, CONTRADICTED),
        ({"literal": no}, OPEN),
        ({"literal": no, "corrected": "f", "correction": no}, OPEN),
        ({"literal": no, "lost": "dots", "restored": no, "corrected": "f", "correction": yes},
         MISPRINTED),
    ],
)  # fmt: skip
def test_the_verdict_follows_from_the_outcomes(readings, verdict):
    assert assess(Entry("0", "what", "how", **readings)).verdict == verdict


@pytest.mark.parametrize(
    "readings",
    [
        {"restored": yes},
        {"lost": "a plus sign", "restored": yes},
        {"condition": "without a check"},
        {"correction": yes},
    ],
)
def test_a_reading_without_its_reason_is_refused(readings):
    with pytest.raises(ValueError, match="0: "):
        Entry("0", "what", "how", no, **readings)
