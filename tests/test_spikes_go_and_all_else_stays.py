"""A map's filter takes out rows that lie far from where those around them lead, and no others."""

import numpy as np
import pytest
from axis_recordings import MAP

from simpter_hybrid.identification.recordings.filtering import Spikes
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.problems import InvalidInput

TIME = 0.004 * np.arange(500)
RAMP = 3.0 * TIME


@pytest.mark.parametrize(("rows", "lasts"), [(7, 1), (11, 2)])
def test_spikes_go_and_all_else_stays(rows, lasts):
    course = RAMP + 0.01 * np.random.default_rng(3).normal(size=TIME.size)
    spiked = course.copy()
    spiked[100 : 100 + lasts] += 5.0
    made = Spikes(rows).apply(TIME, spiked)
    # Noise of 0.01 at the ends of a line, and of what it stands for.
    assert np.abs(made - course).max() < 0.06
    others = np.delete(np.arange(TIME.size), range(100, 100 + lasts))
    assert (made[others] == course[others]).all()


def test_what_lasts_is_no_spike():
    step = RAMP + 5.0 * (TIME > 1.0)
    assert np.ptp(Spikes(7).apply(TIME, step)) == pytest.approx(np.ptp(step))


@pytest.mark.parametrize("course", [RAMP, 0.0 * RAMP, np.round(RAMP, 1)])
def test_of_a_course_without_noise_or_in_steps_nothing_goes(course):
    assert (Spikes(7).apply(TIME, course) == course).all()


def _load(folder, rows):
    angle = 30.0 * np.sin(3.0 * TIME)
    angle[100] += 20.0
    lines = [f"0,{1e3 * t:.1f},{a:.6f},{np.cos(t):.6f}" for t, a in zip(TIME, angle, strict=True)]
    (folder / "data.csv").write_text("\n".join(["take,ms,angle,torque", *lines]), encoding="utf-8")
    key = f'may_rest = true\nfilter = {{ kind = "spikes", rows = {rows} }}\n'
    (folder / "map.toml").write_text(MAP.replace("may_rest = true\n", key), encoding="utf-8")
    return load_recording(folder / "data.csv", folder / "map.toml")


def test_a_map_asks_for_it(tmp_path):
    seen = np.degrees(_load(tmp_path, 7).runs[0].channels["position"])
    # The line between the rows beside it is 4 ms of the wave off, bent by 4e-3 deg.
    assert seen == pytest.approx(-30.0 * np.sin(3.0 * TIME), abs=0.01)


@pytest.mark.parametrize("rows", [8, 5, 53])
def test_what_has_no_middle_or_too_few_rows_is_refused(tmp_path, rows):
    with pytest.raises(InvalidInput, match=rf"filter\.rows.*got {rows}"):
        _load(tmp_path, rows)
