"""Three takes in one table by one clock, whose map names no boundaries."""

import pytest

from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.problems import InvalidInput

MAP = """
[time]
column = "t"
unit = "s"
[runs]
{}
[channels.position]
column = "x"
unit = "m"
sign = 1
role = "measured"
"""


def _read(folder, runs="", apart=5.0, more=lambda take, k: "on"):
    lines = ["take,more,t,x"]
    for take in range(3):
        for k in range(100):
            t = take * apart + 0.01 * k
            lines.append(f"{take},{more(take, k)},{t:.2f},{t * t:.4f}")
    (folder / "data.csv").write_text("\n".join(lines), encoding="utf-8")
    (folder / "map.toml").write_text(MAP.format(runs), encoding="utf-8")
    return load_recording(folder / "data.csv", folder / "map.toml")


def test_it_is_named_with_the_gap_and_where_nothing_can_be_held_out(tmp_path):
    recording = _read(tmp_path)
    assert recording.at_gaps == ("take",)
    (gap,) = (f for f in recording.findings if "gap" in f.what)
    assert 'boundaries = ["take"]' in gap.right
    with pytest.raises(InvalidInput, match=r'as boundaries = \["take"\] under .* parts them'):
        groups_of(recording)


def test_the_first_of_several_is_proposed(tmp_path):
    recording = _read(tmp_path, more=lambda take, k: f"part {take}")
    assert recording.at_gaps == ("take", "more")


@pytest.mark.parametrize(
    "how",
    [
        {"apart": 1.0},  # no rows are missing, whatever the takes are
        {"runs": 'boundaries = ["take"]'},
        {"runs": 'boundaries = ["more"]'},
    ],
)
def test_elsewhere_nothing_is_proposed(tmp_path, how):
    assert _read(tmp_path, **how).at_gaps == ()


def test_a_column_that_changes_elsewhere_too_is_not_it(tmp_path):
    assert _read(tmp_path, more=lambda take, k: f"{take} {k // 50}").at_gaps == ("take",)
