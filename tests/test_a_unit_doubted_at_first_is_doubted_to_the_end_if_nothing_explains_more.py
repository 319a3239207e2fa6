"""Effects and weights of each run take up a little of a wrong unit; the question remains."""

from dataclasses import replace

import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.identification import diagnosis, sought
from simpter_hybrid.identification.doubted_channels import Doubt
from simpter_hybrid.identification.map_changes import Times

EARLY = Doubt(Times(("position",), 57.3), 0.1)


@pytest.mark.parametrize(
    ("times", "kept"), [(2.5, (EARLY,)), pytest.param(1.5, (), marks=pytest.mark.slow)]
)
def test_it_is_asked_where_twice_the_floor_is_left(tmp_path, monkeypatch, times, kept):
    found = sought.with_curve_over_rest

    def far_off(searched, levels, say):
        done, term = found(searched, levels, say)
        left = replace(done.corrected, select_error=times * done.floor)
        return replace(done, corrected=left), term

    monkeypatch.setattr(sought, "with_curve_over_rest", far_off)
    monkeypatch.setattr(diagnosis, "doubted_first", lambda *_: (EARLY,))
    monkeypatch.setattr(diagnosis, "doubted", lambda *_: ())
    told = diagnosis.diagnose(recorded_axis(tmp_path, ()), declared_axis(), [])
    assert told.doubts == kept
