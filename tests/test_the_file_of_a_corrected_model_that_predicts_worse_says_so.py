"""A corrected model that is worse on the runs held out says so at the head of its own file."""

import tomllib

from simpter_hybrid.diagnosis_report import _headed

WORSE = "On the runs held out the corrected model is worse than the declared one"
TEXT = "[run]\nt_end = 1.0\n"


def test_it_is_said_after_the_verdict():
    text = _headed("take.csv", {"sentence": "Something is missing.", "worse": WORSE}, TEXT)
    said = " ".join(line[2:] for line in text.splitlines() if line.startswith("# "))
    assert said.endswith(f"Something is missing. {WORSE}")
    assert tomllib.loads(text) == {"run": {"t_end": 1.0}}
