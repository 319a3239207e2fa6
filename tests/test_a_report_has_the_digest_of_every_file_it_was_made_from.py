import hashlib
from pathlib import Path

import pytest

from simpter_hybrid.identification.reporting.sources import digests, name_of


def test_files_of_a_recording_are_called_by_their_names_or_where_these_are_alike_by_their_folders(
    tmp_path,
):
    files = []
    for name in ("a/take.csv", "b/take.csv", "c/other.csv", "model.toml", "map.toml"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(name, encoding="utf-8")
        files.append(str(tmp_path / name))
    *takes, model, described = files
    model, described = Path(model), Path(described)
    told = digests(takes, model, described)
    assert list(told) == [*takes, "model", "map"]
    assert list(digests(takes[1:], model, described)) == ["take.csv", "other.csv", "model", "map"]
    assert list(digests(takes[:1], model, described)) == ["recording", "model", "map"]
    assert told[takes[1]] == hashlib.sha256(b"b/take.csv").hexdigest()


@pytest.mark.parametrize(
    ("files", "name"),
    [
        (["runs/2026.03.01.csv.gz"], "2026.03.01"),
        (["slide.npz"], "slide"),
        (["a.tsv", "b.tsv"], "a"),
        (["notes.txt"], "notes.txt"),
        (["my data (2).csv"], "my-data-2"),  # the corrected model is a scenario, called so too
        (["\u6e2c\u5b9a.csv"], "recording"),
        ([f"{'long' * 50}.csv"], "long" * 20),
    ],
)
def test_a_diagnosis_is_called_after_its_first_file(files, name):
    assert name_of(files) == name
