"""The flick of a hand at the start of a run, or what came after it, is left out by the map."""

import pytest

from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.problems import InvalidInput

MAP = """
[time]
column = "t"
unit = "s"
[runs]
boundaries = ["take"]
SPAN
[channels.position]
column = "x"
unit = "m"
sign = 1
role = "measured"
"""


def _recorded(folder, span):
    lines = ["take,t,x"]
    for take in range(2):
        lines += [f"{take},{3 + 0.01 * k:.2f},{0.001 * k * k:.3f}" for k in range(400)]
    (folder / "data.csv").write_text("\n".join(lines), encoding="utf-8")
    (folder / "map.toml").write_text(MAP.replace("SPAN", span), encoding="utf-8")
    return load_recording(folder / "data.csv", folder / "map.toml")


def test_rows_before_and_after_do_not_count(tmp_path):
    found = _recorded(tmp_path, 'from = "0.5 s"\nuntil = "2 s"')
    for run in found.runs:
        assert (run.time[0], run.time[-1]) == pytest.approx((3.5, 5.0), abs=1e-9)
        assert run.channels["position"][0] == pytest.approx(2.5, abs=1e-9)


def test_the_row_at_which_it_begins_counts_whatever_its_digits(tmp_path):
    found = _recorded(tmp_path, 'from = "0.3 s"')  # 3.3 - 3.0 is a little less than that
    assert found.runs[0].time[0] == pytest.approx(3.3, abs=1e-9)


def test_pieces_are_cut_of_the_rows_that_count(tmp_path):
    found = _recorded(tmp_path, 'from = "2 s"\npieces = 2')
    assert [run.time.size for run in found.runs] == [100, 100, 100, 100]


def test_nothing_left_is_refused_with_how_long_the_run_is(tmp_path):
    with pytest.raises(InvalidInput, match=r"take 0 lasts 3\.99 s.*from 4 s on, counted"):
        _recorded(tmp_path, 'from = "4 s"')
    with pytest.raises(InvalidInput, match=r"from 4 s on and up to 5 s, counted"):
        _recorded(tmp_path, 'from = "4 s"\nuntil = "5 s"')


def test_an_end_before_the_begin_is_refused(tmp_path):
    with pytest.raises(InvalidInput, match="until"):
        _recorded(tmp_path, 'from = "2 s"\nuntil = "1 s"')
