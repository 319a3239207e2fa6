"""The event table takes time by the number of events, not by its square."""

import pytest
from sampled_runs import oscillator

from simpter_hybrid.explanation import explain
from simpter_hybrid.files.storage import events_csv
from simpter_hybrid.report import page


@pytest.mark.parametrize("table", [events_csv, page.event_rows])
def test_the_whole_run_is_looked_through_once_for_all_its_events(table, monkeypatch):
    looks, look = [], explain.segments_around

    def counted(trajectory):
        looks.append(trajectory)
        return look(trajectory)

    for module in (explain, page):
        monkeypatch.setattr(module, "segments_around", counted, raising=False)
    assert len(oscillator().events) > 3
    table(oscillator())
    assert len(looks) == 1
