"""A gyroscope shows a speed where nothing turns: no friction and no force does that."""

import pytest
from axis_recordings import MAP, SPEED, declared_axis, recorded_axis

from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.axis.speed_sensor import OFFSET, begun_right
from simpter_hybrid.identification.benches import as_recorded, bench_of
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.identification.result import corrected

RIVALS = ("speed-offset", "bias-force", "asymmetry", "viscous-drag", "stribeck")


@pytest.fixture
def recording(tmp_path):
    recorded_axis(tmp_path, [], rate_noise=0.01)
    off = MAP + SPEED + 'offset = "0.05 rad/s"\n'
    (tmp_path / "map.toml").write_text(off, encoding="utf-8")
    return as_recorded(load_recording(tmp_path / "data.csv", tmp_path / "map.toml"))


def _diagnosed(recording, declared):
    bench = bench_of(recording, declared, groups_of(recording))
    tried = tuple(c for c in bench.candidates if c.name in RIVALS)
    return diagnose(recording, declared, candidates=tried)


@pytest.mark.slow
def test_it_is_found_and_a_model_with_it_lacks_nothing(recording):
    found = _diagnosed(recording, declared_axis())
    assert [e.name for e in found.search.corrected.effects] == ["speed-offset"]
    # Turned round by the map's sign; noise of 0.01 rad/s over hundreds of rows in motion.
    assert found.search.corrected.values[OFFSET] == pytest.approx(-0.05, abs=0.001)
    again = corrected(found, "corrected")
    (channel,) = again.notes["readings"].channels
    assert channel.signal == "speed of joint"
    assert _diagnosed(recording, again).search.verdict.kind == "nothing missing"


def test_it_is_not_asked_where_no_speed_was_measured(tmp_path):
    positions = recorded_axis(tmp_path, [])
    bench = bench_of(positions, declared_axis(), groups_of(positions))
    assert "speed-offset" not in {c.name for c in bench.candidates}


def test_a_declared_one_moves_no_start_that_positions_tell(tmp_path):
    (run, *_) = axis_replays(recorded_axis(tmp_path, []), AxisSignals())
    assert begun_right(run, {OFFSET: 0.3}) is run
