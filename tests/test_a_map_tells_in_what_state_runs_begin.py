"""The ``[start]`` of a map: pendulums that are let go at rest, and mistakes in saying so."""

from dataclasses import replace

import numpy as np
import pytest
from axis_recordings import MAP, written
from filmed_swings import DECLARED, LET_ALONE

from simpter_hybrid.identification.axis.bench import axis_bench
from simpter_hybrid.identification.axis.halves import halves
from simpter_hybrid.identification.axis.recorded import as_axis
from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.axis.told_start import told_start
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.problems import InvalidInput

AT_REST = '[start]\nspeed = "0 deg/s"\n'
#: In the model's angle, which the film shows turned round.
FROM_HALF = '[start]\nposition = "0.5 rad"\n'
PIECES = 'boundaries = ["take"]\npieces = 2'
TIME = 0.02 * np.arange(200)


def takes(folder, more, described=LET_ALONE):
    """Four takes let go at half a radian, a little turn each."""
    rows = ["take,ms,angle"]
    for take in range(4):
        angle = 0.5 * np.cos(5.0 * TIME) * np.exp(-0.1 * (take + 1) * TIME)
        noise = 1e-3 * np.random.default_rng(take).standard_normal(TIME.size)
        rows += [
            f"{take},{1e3 * t:.0f},{-np.degrees(q):.5f}"
            for t, q in zip(TIME, angle + noise, strict=True)
        ]
    return as_axis(written(folder, rows, described + more))


def first_starts(recording, part="fit"):
    bench = axis_bench(recording, DECLARED, groups_of(recording))
    return [run.notes["start"] for run in bench.parts[part]], bench.parts[part]


def test_a_speed_of_zero_is_taken_as_told(tmp_path):
    starts, runs = first_starts(takes(tmp_path, AT_REST))
    assert [start[1] for start in starts] == [0.0] * len(starts)
    assert all(run.start_free and run.start_told == (False, True) for run in runs)


def test_a_position_is_that_of_the_model_behind_sign_and_offset(tmp_path):
    starts, runs = first_starts(takes(tmp_path, FROM_HALF))
    assert [start[0] for start in starts] == [0.5] * len(starts)
    assert all(run.start_told == (True, False) for run in runs)


def test_of_what_goes_on_from_before_it_tells_nothing(tmp_path):
    cut = LET_ALONE.replace('boundaries = ["take"]', PIECES)
    assert cut != LET_ALONE
    recording = takes(tmp_path, FROM_HALF, cut.partition("[split]")[0] + channels_of(cut))
    assert [run.begins for run in recording.runs] == [True, False] * 4


def channels_of(text):
    """The channels' tables of a map, which stand last."""
    return text[text.index("[channels") :]


def test_another_place_is_refused_with_both(tmp_path):
    with pytest.raises(InvalidInput, match=r"got 28\.6.*expected -28\.6479 deg") as refused:
        told_start(takes(tmp_path, '[start]\nposition = "-0.5 rad"\n'))
    assert len(refused.value.problems) == 4


def test_a_place_that_is_a_little_off_is_remarked(tmp_path):
    found = told_start(takes(tmp_path, '[start]\nposition = "0.55 rad"\n'))
    assert [f.run for f in found] == ["take 0", "take 1", "take 2", "take 3"]
    assert not told_start(takes(tmp_path, FROM_HALF))


def test_another_speed_is_remarked(tmp_path):
    # The highest is 2.5 rad/s.
    found = told_start(takes(tmp_path, '[start]\nspeed = "0.3 rad/s"\n'))
    assert [f.run for f in found] == ["take 0", "take 1", "take 2", "take 3"]
    assert not told_start(takes(tmp_path, AT_REST))


def test_so_are_runs_whose_first_rows_are_left_out(tmp_path):
    recording = takes(tmp_path, AT_REST)
    first, *others = recording.runs
    later = replace(recording, runs=(first.only(slice(20, None)), *others))
    (found,) = told_start(later)
    assert found.value == "take 0"
    assert "is not used where a run's first rows are left out" in found.what


def test_only_the_first_half_of_a_run_begins_as_told(tmp_path):
    run = axis_replays(takes(tmp_path, AT_REST), AxisSignals())[0]
    first, second = halves(run)
    assert (first.start_told, second.start_told) == ((False, True), (False, False))
    assert (first.notes["start"][1], second.notes["start"][1] == 0.0) == (0.0, False)


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ('[start]\nspeed = "0 mm"\n', "not a quantity in the channel's unit"),
        ('[start]\nplace = "0 deg"\n', "unknown key"),
        ("[start]\n", "nothing in it"),
    ],
)
def test_what_cannot_be_is_refused(tmp_path, more, said):
    with pytest.raises(InvalidInput, match=said):
        takes(tmp_path, more)


def test_so_it_is_if_the_first_rows_do_not_count(tmp_path):
    late = LET_ALONE.replace("[runs]", '[runs]\nfrom = "0.1 s"')
    assert late != LET_ALONE
    with pytest.raises(InvalidInput, match="of the first rows, which do not count"):
        takes(tmp_path, AT_REST, late)


def test_so_is_a_place_where_positions_were_not_logged(tmp_path):
    (tmp_path / "data.csv").write_text("run,s,rate\n")
    speed = MAP.replace("channels.position", "channels.speed")
    (tmp_path / "map.toml").write_text(speed + FROM_HALF)
    with pytest.raises(InvalidInput, match="no channel of that name"):
        load_recording(tmp_path / "data.csv", tmp_path / "map.toml")
