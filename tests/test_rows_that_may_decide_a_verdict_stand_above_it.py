"""What may change a name is no matter for the foot of a report, among the data that were used."""

from simpter_hybrid.identification.recordings.checks import Finding
from simpter_hybrid.identification.recordings.driven_on import DRIVEN_ON
from simpter_hybrid.identification.recordings.lone_speeds import LONE
from simpter_hybrid.identification.reporting.odd_rows import odd_rows_sentence
from simpter_hybrid.identification.reporting.page import DOUBTED


def test_rows_that_may_decide_a_verdict_stand_above_it():
    found = [
        Finding("run 2", DRIVEN_ON, "0.104 s", "", 0, 0.0),
        Finding("run 3", f"speed {LONE}", "0 rpm", "", 27, 10.064),
        Finding("run 3", "a gap", "1.5 s", "", 90, 13.0),
    ]
    said = odd_rows_sentence(found)
    assert "Was the axis let go only then? It holds its speed at first (run 2 for 0.104 s)" in said
    assert "dropped or misread (speed 0 rpm, run 3, t = 10.064 s)" in said
    assert "gap" not in said
    assert "odd_rows" in DOUBTED
