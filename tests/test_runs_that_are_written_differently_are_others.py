"""The tenth trial of the first day, 1.10, is not its first, 1.1."""

import pytest
from axis_recordings import MAP

from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.identification.recordings.run_names import names_of

WHOLE = MAP[: MAP.index("[split]")] + MAP[MAP.index("[channels.position]") :]


def _runs(folder, files, more=""):
    """Runs of files, each of which has these takes."""
    (folder / "map.toml").write_text(WHOLE + more, encoding="utf-8")
    names = []
    for n, takes in enumerate(files):
        rows = [f"{take},{k},{k % 7},{k % 5}" for take in takes for k in range(60)]
        names.append(folder / f"{n}.csv")
        text = "\n".join(["take,ms,angle,torque", *rows])
        names[-1].write_text(text, encoding="utf-8")
    return load_recording(names, folder / "map.toml").runs


@pytest.mark.parametrize(
    "takes", [("1.1", "1.2", "1.10"), ("1.1", "1.10"), ("1_1", "1_2", "11"), ("1e3", "1000")]
)
def test_they_have_the_names_and_groups_that_are_written(tmp_path, takes):
    runs = _runs(tmp_path, [takes])
    assert [run.name for run in runs] == [f"take {take}" for take in takes]
    assert [run.group for run in runs] == [run.name for run in runs]


def test_so_they_have_in_another_file(tmp_path):
    runs = _runs(tmp_path, [("1.1", "1.2"), ("1.10", "1.2")])
    assert [run.group for run in runs] == ["take 1.1", "take 1.2", "take 1.10", "take 1.2"]


def test_beside_texts_of_another_file_a_number_is_the_same_take(tmp_path):
    runs = _runs(tmp_path, [("1.0", "2.0"), ("1.0", "calm")])
    assert [run.group for run in runs] == ["take 1.0", "take 2.0", "take 1.0", "take calm"]


@pytest.mark.parametrize("other", ["1.1", "1.2"])
def test_one_is_asked_for_as_it_is_written(tmp_path, other):
    (run,) = _runs(tmp_path, [(other, "1.10")], '[only]\ntake = "1.10"\n')
    assert run.rows == (60, 120)


def test_without_one_beside_it_a_number_is_called_as_it_always_was():
    told, number = names_of(["1.0", "2.50", "nan", "NaN"])
    assert told["1.0"] == "1"
    assert number["2.50"] == 2.5


def test_a_whole_number_is_one_however_a_program_wrote_it(tmp_path):
    runs = _runs(tmp_path, [("1", "3"), ("1.0", "2.0")])
    assert [run.group for run in runs] == ["take 1", "take 3", "take 1", "take 2"]
    told, number = names_of(["1", "1.0", "1."])
    assert set(told.values()) == {"1"}
    assert number["1."] == 1.0


def test_it_is_asked_for_in_either_way(tmp_path):
    runs = _runs(tmp_path, [("1", "3"), ("1.0", "2.0")], '[only]\ntake = "1.0"\n')
    assert [run.rows for run in runs] == [(0, 60), (120, 180)]
