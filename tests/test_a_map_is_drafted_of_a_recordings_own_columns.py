"""`simpter check RECORDING` prints a map to fill in: columns and rows as seen, nothing guessed."""

import tomllib

import numpy as np
import pytest

from simpter_hybrid.cli import main
from simpter_hybrid.identification.recordings.draft_map import draft_map
from simpter_hybrid.identification.recordings.map_file import read_map
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.problems import InvalidInput

ROWS = [(take, 0.01 * k, 9.0 * np.sin(0.2 * k), -1.0) for take in (1, 2) for k in range(60)]
#: Signal, unit and role of the two channels that are drafted.
ANSWERS = (("position", "mm", "measured"), ("force", "N", "input"))


def recorded(path, head="take,t,x,F", row="{},{:.2f},{:.3f},{}"):
    path.write_text("\n".join([head, *(row.format(*r) for r in ROWS)]) + "\n")
    return str(path)


def filled(draft: str) -> str:
    """What a user makes of it: units, signs, roles and names; no other word."""
    head, _, channels = draft.partition('[channels."? 1"]')
    text = head.replace('boundaries = ["?"]', 'boundaries = ["take"]')
    text = text.replace('group = ["?"]', 'group = ["take"]').replace('unit = "?"', 'unit = "s"')
    channels = f'[channels."? 1"]{channels}'
    for k, (signal, unit, role) in enumerate(ANSWERS, 1):
        before, _, one = channels.partition(f'[channels."? {k}"]')
        for answer in (f'"{unit}"', "1", f'"{role}"'):
            one = one.replace('"?"', answer, 1)
        channels = f"{before}[channels.{signal}]{one}"
    return text + channels


def test_a_draft_that_was_filled_in_reads_the_recording(tmp_path):
    file = recorded(tmp_path / "rec.csv")
    (tmp_path / "map.toml").write_text(filled(draft_map(file)))
    recording = load_recording(file, tmp_path / "map.toml")
    assert [run.time.size for run in recording.runs] == [60, 60]
    assert np.allclose(recording.runs[1].channels["position"][:3], [0.0, 0.001788, 0.003505])


def test_a_draft_is_refused_with_all_that_was_not_filled_in(tmp_path):
    file = tmp_path / "map.toml"
    file.write_text(draft_map(recorded(tmp_path / "rec.csv")))
    with pytest.raises(InvalidInput) as error:
        read_map(file)
    wrong = [p.path for p in error.value.problems]
    assert {"time.unit", "runs.boundaries", "runs.group"} <= set(wrong)
    for key in ("unit", "sign", "role"):
        assert sum(path.endswith(key) and "channels" in path for path in wrong) == 2
    assert sum(p.what == "a signal not filled in" for p in error.value.problems) == 2


def test_the_column_that_changes_where_the_time_begins_anew_is_pointed_at(tmp_path):
    text = draft_map(recorded(tmp_path / "rec.csv"))
    assert "#   take: 1, 2; changes once, wherever the time begins anew" in text


def test_what_stands_above_the_numbers_and_a_decimal_comma_are_seen(tmp_path):
    file = tmp_path / "lab.txt"
    rows = "\n".join(f"{0.5 * k:.1f};{0.25 * k:.2f}".replace(".", ",") for k in range(9))
    file.write_text(f"Operator;ab\nRate;2;Hz\n\nt;x\ns;mm\n{rows}\n")
    table = tomllib.loads(draft_map(str(file)))["table"]
    assert table == {"names": 4, "rows": 6, "decimal": ","}


def test_a_table_without_names_gets_names_to_be_replaced(tmp_path):
    file = tmp_path / "bare.dat"
    file.write_text("\n".join(f"{0.1 * k:.1f}  {np.sin(k):.3f}" for k in range(50)))
    draft = tomllib.loads(draft_map(str(file)))
    assert draft["table"] == {"columns": ["c1", "c2"]}
    assert draft["time"]["column"] == "c1"


@pytest.mark.parametrize("rows", ["{t},{x},", "{t},{x},{T}"])
def test_a_last_column_that_is_seldom_written_is_one_all_the_same(tmp_path, rows):
    file = tmp_path / "rec.csv"
    lines = [rows.format(t=k / 10, x=k % 3, T=20 if k % 10 == 5 else "") for k in range(50)]
    file.write_text("\n".join(["t,x,T", *lines]))
    draft = tomllib.loads(draft_map(str(file)))
    assert "table" not in draft
    columns = [c["column"] for c in draft["channels"].values()]
    assert columns == (["x", "T"] if "T" in rows else ["x"])


def test_dates_that_do_not_rise_tell_no_time(tmp_path):
    file = tmp_path / "rec.csv"
    rows = (f"2024-01-01,{k / 10},2024-01-01T00:00:{k:02d},{k % 3}" for k in range(50))
    file.write_text("\n".join(["day,t,at,x", *rows]))
    text = draft_map(str(file))
    assert "these rise throughout: t, at" in text
    assert [c["column"] for c in tomllib.loads(text)["channels"].values()] == ["t", "x"]


def test_the_time_is_left_open_where_several_columns_rise(tmp_path):
    file = tmp_path / "two.csv"
    file.write_text("n,t,x\n" + "\n".join(f"{k},{0.1 * k},{k % 3}" for k in range(50)))
    text = draft_map(str(file))
    assert tomllib.loads(text)["time"]["column"] == "?"
    assert "these rise throughout: n, t" in text


def test_named_arrays_are_drafted_too(tmp_path):
    file = tmp_path / "rec.npz"
    np.savez(file, t=np.arange(40) / 100.0, x=np.zeros(40))
    text = draft_map(str(file))
    assert tomllib.loads(text)["channels"]["? 1"]["column"] == "x"
    assert "always 0" in text


def test_check_prints_it_and_a_missing_map_says_so(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    recorded(tmp_path / "rec.csv")
    assert main(["check", "rec.csv"]) == 0
    assert tomllib.loads(capsys.readouterr().out)["time"]["column"] == "t"
    assert main(["diagnose", "rec.csv", "--model", "line-y24"]) == 2
    assert "simpter check rec.csv" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("name", "text"), [("empty.csv", ""), ("words.csv", "a\nb\n"), ("sheet.xlsx", "")]
)
def test_what_is_no_recording_is_refused(tmp_path, name, text):
    (tmp_path / name).write_text(text)
    with pytest.raises(InvalidInput):
        draft_map(str(tmp_path / name))
