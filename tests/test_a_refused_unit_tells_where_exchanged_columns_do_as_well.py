"""A voltage for a speed looks like a unit that is off by a thousand: the columns are asked, too."""

from types import SimpleNamespace as Some

import numpy as np
import pytest

from simpter_hybrid.identification import doubted_first, hopeless
from simpter_hybrid.identification.doubted_channels import Doubt
from simpter_hybrid.identification.map_changes import Times
from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.recorded_run import RecordedRun
from simpter_hybrid.identification.recordings.recording import Recording

CHANNELS = {
    "speed": ChannelMap("speed", "u", "rpm", "measured", 0.1, sign=-1),
    "drive": ChannelMap("drive", "w", "V", "input"),
}
DOUBT = Doubt(Times(("speed",), 1000.0), 0.001)


def said(monkeypatch, exchanged, with_unit=6.6):
    """The words where a model errs so much more than rest: with columns exchanged, with a unit."""
    values = {n: np.array([1.0, 2.0]) for n in CHANNELS}
    run = RecordedRun("a", "a", "a", (0, 2), np.arange(2.0), values)
    recording = Recording("file", Some(channels=CHANNELS, source="map.toml"), (run,))
    monkeypatch.setattr(Times, "made", lambda _, recording: Some(runs=()))
    for module in (doubted_first, hopeless):
        monkeypatch.setattr(module, "over_rest", lambda _, runs: runs)
    made = []

    def error(recording, part):
        made.append(recording)
        return exchanged if recording.runs else with_unit

    bench = Some(made=error, predictor=Some(predict=lambda *given: {}))
    told = doubted_first._as_well(bench, recording, {}, DOUBT)
    return told, made[-1].runs[0].channels


@pytest.mark.parametrize(("exchanged", "asked"), [(1.2, True), (7.9, True), (9.0, False)])
def test_where_the_model_errs_no_more_so(monkeypatch, exchanged, asked):
    told, _ = said(monkeypatch, exchanged)
    assert ("are the columns of drive and speed exchanged?" in told) is asked


def test_each_column_is_read_in_the_unit_and_sign_of_the_other_channel(monkeypatch):
    _, channels = said(monkeypatch, 1.2)
    assert channels["drive"] == pytest.approx([-10.0, -20.0])
    assert channels["speed"] == pytest.approx([-0.1, -0.2])
