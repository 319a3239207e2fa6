"""What the report says of the corrected model: the lines in which it differs."""

import tomllib

from simpter_hybrid.diagnosis_report import WIDTH, _headed, changes

DECLARED = 'name = "a"\n[device]\nkind = "one-axis"\nmass = "3 kg"\nlength = "1 m"\n'


def test_only_what_changed_with_a_line_around_it():
    corrected = DECLARED.replace("3 kg", "3.1 kg")
    found = changes(DECLARED, corrected)
    assert [line for line in found if line[0] in "+-" and line[:3] not in ("+++", "---")] == [
        '-mass = "3 kg"',
        '+mass = "3.1 kg"',
    ]
    assert ' kind = "one-axis"' in found
    assert 'name = "a"' not in "\n".join(found)


def test_a_model_as_declared_has_none():
    assert changes(DECLARED, DECLARED) == []


def test_its_file_begins_with_what_it_is_the_correction_of():
    verdict = "The model lacks stribeck; " + "with it the error is what noise leaves. " * 5
    text = _headed("take\x07.csv", {"sentence": verdict, "worse": ""}, "[run]\nt_end = 1.0\n")
    head = [line for line in text.splitlines() if line.startswith("# ")]
    assert max(map(len, head)) <= WIDTH
    assert "simpter diagnose take?.csv" in head[0]
    assert tomllib.loads(text) == {"run": {"t_end": 1.0}}
