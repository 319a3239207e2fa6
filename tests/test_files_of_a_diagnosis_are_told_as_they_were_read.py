"""A file that changes while a diagnosis goes on: the report tells of what was read."""

import hashlib

from axis_recordings import MAP, MODEL, ROWS

from simpter_hybrid.identification.reporting.request import read_request


def test_digests_and_map_are_of_the_files_as_read(tmp_path):
    for name, text in {"m.toml": MODEL, "map.toml": MAP, "d.csv": "\n".join(ROWS)}.items():
        (tmp_path / name).write_text(text)
    right = hashlib.sha256((tmp_path / "d.csv").read_bytes()).hexdigest()
    request = read_request(tmp_path / "d.csv", tmp_path / "m.toml")
    (tmp_path / "d.csv").write_text("changed")
    (tmp_path / "map.toml").unlink()
    assert request.digests["recording"] == right
    assert request.map_text == MAP
