import gzip
import os
from pathlib import Path

import numpy as np
import pytest

import simpter_hybrid.identification as package
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.problems import InvalidInput

DATA = Path(os.environ.get("SIMPTER_DATA", Path(__file__).parents[2] / "shared" / "data"))
MAPS = Path(package.__file__).parent / "maps"

MAP = """
[time]
column = "t[ms]"
unit = "ms"
[runs]
boundaries = ["run"]
[channels.torque]
column = "T"
unit = "lbf*in"
sign = -1
offset = "2 lbf*in"
role = "measured"
"""


def _table(rows=120, spoil=lambda table: None):
    table = [[1 + (k >= 60), k % 60 * 2.0, np.sin(0.3 * k)] for k in range(rows)]
    spoil(table)
    lines = ["run,t[ms],T"] + [",".join(str(c) for c in row) for row in table]
    return "\n".join(lines) + "\n"


def _load(tmp_path, text, name="data.csv", described=MAP):
    (tmp_path / "map.toml").write_text(described)
    data = tmp_path / name
    if name.endswith(".gz"):
        data.write_bytes(gzip.compress(text.encode()))
    elif name.endswith(".npz"):
        numbers = np.genfromtxt(text.splitlines(), delimiter=",", names=None, skip_header=1)
        columns = dict(zip(["run", "t[ms]", "T"], numbers.T, strict=True))
        np.savez(data, **columns)
    else:
        data.write_text(text)
    return load_recording(data, tmp_path / "map.toml")


@pytest.mark.parametrize("name", ["data.csv", "data.csv.gz", "data.npz", "data.tsv"])
def test_units_sign_and_offset(tmp_path, name):
    text = _table()
    recording = _load(tmp_path, text.replace(",", "\t") if name.endswith(".tsv") else text, name)
    first = recording.runs[0]
    assert [r.name for r in recording.runs] == ["run 1", "run 2"]
    assert first.time[1] == pytest.approx(0.002, rel=1e-15)
    # 1 lbf*in = 4.4482216152605 N * 0.0254 m exactly; sign * (value + offset).
    wanted = -(np.sin(0.3 * np.arange(60)) + 2) * 4.4482216152605 * 0.0254
    assert first.channels["torque"] == pytest.approx(wanted, rel=1e-12)


def test_everything_wrong_is_reported_at_once(tmp_path):
    def spoil(table):
        table[10][1] = 5.0  # run 1: time backwards
        table[80][2] = float("nan")  # run 2

    with pytest.raises(InvalidInput) as caught:
        _load(tmp_path, _table(spoil=spoil))
    text = str(caught.value)
    assert "data.csv:12 (run 1" in text
    assert "time goes backwards" in text
    assert "data.csv:82 (run 2, t = 0.04 s)" in text
    assert "torque is not a finite number" in text


def test_a_cell_that_is_no_number_is_named_by_its_line(tmp_path):
    def spoil(table):
        table[3][2] = "broken"

    with pytest.raises(InvalidInput, match=r"data.csv:5: column 'T' is not a number"):
        _load(tmp_path, _table(spoil=spoil))


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (("sign = -1\n", ""), "channels.torque.sign: missing"),
        (('unit = "lbf*in"', 'unit = "lb"'), "channels.torque.unit: a unit not understood"),
        (('column = "T"', 'column = "tau"'), "a column of the map is not in the file"),
    ],
)
def test_nothing_is_guessed(tmp_path, change, message):
    with pytest.raises(InvalidInput) as caught:
        _load(tmp_path, _table(), described=MAP.replace(*change))
    assert message in str(caught.value)


def test_a_stuck_a_saturated_sensor_and_a_gap_are_found(tmp_path):
    described = MAP.replace('[runs]\nboundaries = ["run"]\n', "") + (
        'limits = ["-0.5 lbf*in", "5 lbf*in"]\n'
    )

    def spoil(table):
        for k, row in enumerate(table):
            row[1] = 2.0 * k + (100.0 if k > 200 else 0.0)
            row[2] = 0.1 if 300 <= k < 520 else row[2]

    recording = _load(tmp_path, _table(700, spoil), described=described)
    found = "\n".join(f.what for f in recording.findings)
    assert found.startswith("a gap")
    assert "torque repeats one value for 220 samples" in found
    assert "torque saturated in" in found


def test_an_optional_channel_that_was_not_recorded_is_absent(tmp_path):
    speed = """
[channels.speed]
column = "w"
unit = "rad/s"
sign = 1
role = "measured"
optional = true
"""
    missing = _load(tmp_path, _table(), described=MAP + speed)
    header, *rows = _table().splitlines()
    empty = _load(
        tmp_path, "\n".join([header + ",w"] + [r + "," for r in rows]), described=MAP + speed
    )
    for recording in (missing, empty):
        assert recording.absent == ("speed",)
        assert set(recording.runs[0].channels) == {"torque"}


@pytest.mark.skipif(not DATA.is_dir(), reason="the data are not here (SIMPTER_DATA)")
@pytest.mark.parametrize(
    ("described", "data", "runs"),
    [
        ("robot", "robot/practice/null.csv.gz", 8),
        ("bam_xl330", "bam_xl330/data.csv", 16),
        ("dfki_pendulum", "dfki_pendulum/data.csv", 9),
        ("dfki_double_pendulum", "dfki_double_pendulum/data.csv.gz", 10),
        ("emps", "emps/data.csv.gz", 2),
        ("pneu_seal", "pneu_seal/data.csv.gz", 4),
        ("pneu_seal_repeats", "pneu_seal/data.csv.gz", 20),
    ],
)
def test_the_maps_that_come_with_the_package_fit_the_data(described, data, runs):
    assert len(load_recording(DATA / data, MAPS / f"{described}.toml").runs) == runs


@pytest.mark.parametrize("role", ["measured", "input"])
def test_an_optional_sensor_may_be_blank_in_whole_runs_but_no_input(tmp_path, role):
    def spoil(table):
        for row in table[60:]:
            row[2] = np.nan

    described = MAP.replace('role = "measured"', f'role = "{role}"\noptional = true')
    if role == "input":
        with pytest.raises(InvalidInput, match="not a finite number in 60 samples"):
            _load(tmp_path, _table(spoil=spoil), described=described)
        return
    first, second = _load(tmp_path, _table(spoil=spoil), described=described).runs
    assert [list(run.channels) for run in (first, second)] == [["torque"], []]
