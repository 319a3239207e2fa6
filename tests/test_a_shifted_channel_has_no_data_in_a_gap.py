"""Where rows are missing, a channel that is moved in time has no value, and none is made up."""

import numpy as np
import pytest
from axis_recordings import MAP

from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.clocks import known_at, moved
from simpter_hybrid.identification.recordings.gaps import runs_between_gaps
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.problems import InvalidInput

ROWS = np.arange(600)
KEPT = ROWS[(ROWS < 200) | (ROWS >= 350)]  # 4 ms each; a gap of 0.6 s
TIME = 0.004 * ROWS


def _load(folder, shift, held="sampled", head="", where=""):
    rows = [
        f"0,{4 * k},{10 * np.sin(3 * t):.6f},{np.cos(5 * t):.6f},{int(k < 500)}"
        for k, t in zip(KEPT.tolist(), TIME[KEPT].tolist(), strict=True)
    ]
    lines = ["take,ms,angle,torque,on", *rows]
    (folder / "data.csv").write_text("\n".join(lines), encoding="utf-8")
    described = f'{head or MAP.rstrip()}\nclock_shift = "{shift} ms"\nheld = "{held}"\n{where}'
    (folder / "map.toml").write_text(described, encoding="utf-8")
    return load_recording(folder / "data.csv", folder / "map.toml")


@pytest.mark.parametrize("held", ["sampled", "after", "before"])
@pytest.mark.parametrize("shift", [20, -20, 800])
def test_rows_without_data_are_left_out(tmp_path, shift, held):
    recording, by = _load(tmp_path, shift, held), shift // 4
    run, channel = recording.runs[0], recording.channels["torque"]
    # Rows of which the one that was taken `by` rows before was not lost.
    known = [k for k in KEPT.tolist() if k - by in KEPT]
    np.testing.assert_allclose(run.time, TIME[known], atol=1e-12)
    wanted = channel.to_si(np.cos(5 * TIME[np.array(known) - by]))
    np.testing.assert_allclose(run.channels["torque"], wanted, atol=1e-6)
    # The file's rows are still told, though some are left out.
    assert [run.row(k) for k in range(run.time.size)] == np.searchsorted(KEPT, known).tolist()


def test_shifts_by_which_no_row_is_known_are_refused(tmp_path):
    # 0.8 s before the gap, 1 s behind it: each of the two has data only where the other has none.
    head = MAP.rstrip().replace('column = "angle"', 'column = "angle"\nclock_shift = "-592 ms"')
    with pytest.raises(InvalidInput, match="too few samples in a run"):
        _load(tmp_path, 600, head=head)


def test_what_is_behind_the_gap_is_a_run_from_its_first_known_row_on(tmp_path):
    recording = _load(tmp_path, 20)
    cut = runs_between_gaps(recording, (), 0.1)
    assert [run.rows for run in cut] == [(5, 200), (205, 450)]
    (gap,) = [f for f in recording.findings if "a gap" in f.what]
    assert (gap.row, gap.value) == (199, "0.624 s")


def test_pieces_of_a_run_end_where_they_did(tmp_path):
    # The first of two pieces has the gap; where it is cut the second has data from the first.
    head = MAP.replace('boundaries = ["take"]\ngroup = ["take"]', "pieces = 2")
    head = head.split("[split]")[0] + head[head.index("[channels.position]") :]
    one, other = _load(tmp_path, 20, head=head.rstrip()).runs
    assert (one.rows, other.rows) == ((5, 225), (225, 450))
    assert (one.time.size, other.time.size) == (215, 225)
    np.testing.assert_allclose(other.time, TIME[KEPT][225:], atol=1e-12)


def test_what_applies_in_some_rows_has_no_value_in_those(tmp_path):
    run = _load(tmp_path, 20, where='where = { column = "on", equals = 1 }\n').runs[0]
    none = np.isnan(run.channels["torque"])
    assert run.rows == (5, 450)
    assert run.time.size == 445
    assert np.flatnonzero(none).tolist() == [*range(195, 200), *range(345, 445)]


@pytest.mark.parametrize("held", ["sampled", "after", "before"])
def test_without_a_gap_each_row_inside_is_known(held):
    channel = ChannelMap("drive", "u", "V", "input", held=held, clock_shift=0.03)
    known = known_at(TIME, channel)
    assert np.flatnonzero(~known).tolist() == list(range(8))
    at = moved(TIME, np.sin(TIME), channel)[known]
    np.testing.assert_allclose(at, np.sin(TIME - 0.03)[known], atol=3e-3)
