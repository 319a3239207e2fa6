"""What took minutes to find is on the disk, whatever its pictures come to."""

from types import SimpleNamespace

import pytest

from simpter_hybrid import diagnosis_report as report
from simpter_hybrid.plots import diagnosis as plots


def test_data_and_model_are_written_without_pictures(tmp_path, monkeypatch):
    def breaks(*_):
        raise ZeroDivisionError

    monkeypatch.setattr(plots, "pictures", breaks)
    monkeypatch.setattr(report, "page", lambda data, drawn, text: f"{len(drawn)} pictures")
    found = SimpleNamespace(recording=None)
    made = report.DiagnosisReport(found, {"verdict": "effect"}, None, "[run]", {}, None, None)
    with pytest.raises(ZeroDivisionError):
        made.save(tmp_path / "out")
    assert (tmp_path / "out" / "corrected.toml").read_text() == "[run]"
    assert (tmp_path / "out" / "report.html").read_text() == "0 pictures"
    assert '"verdict": "effect"' in (tmp_path / "out" / "diagnosis.json").read_text()


def test_a_channel_that_rests_in_all_runs_held_out_has_no_bar():
    errors = {stage: {"position": 2.0, "force": 0.0} for stage in plots.STAGES}
    picture = plots.error_ladder(SimpleNamespace(errors=errors))
    texts = [text.get_text() for text in picture.axes[0].texts]
    assert set(texts) == {"1", ""}
