"""What took minutes to find is written first; then the error is raised, for it is one."""

import pytest
from axis_recordings import MODEL, recorded_axis

from simpter_hybrid.diagnosis_report import diagnosed
from simpter_hybrid.identification.reporting import data
from simpter_hybrid.identification.reporting.request import read_request


def test_the_report_is_written_and_the_error_raised(tmp_path, monkeypatch):
    def fails(_):
        raise IndexError("no such row")

    monkeypatch.setattr(data, "dying_out_sentence", fails)
    recorded_axis(tmp_path, [])
    (tmp_path / "axis.toml").write_text(MODEL)
    files = (tmp_path / name for name in ("data.csv", "axis.toml", "map.toml"))
    report = diagnosed(read_request(*files, sight=False), ended=lambda: True)
    with pytest.raises(IndexError, match="no such row"):
        report.save(tmp_path / "out")
    assert "(dying_out: IndexError, no such row)" in (tmp_path / "out/report.html").read_text()
