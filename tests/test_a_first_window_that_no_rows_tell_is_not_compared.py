"""A run that begins faster than its rows can tell is compared from its second window on."""

import numpy as np
import pytest
from axis_recordings import MAP, declared_axis, written

from simpter_hybrid.identification.axis.bench import axis_bench
from simpter_hybrid.identification.axis.starts import BEGUN_UNTOLD
from simpter_hybrid.identification.recordings.groups import groups_of

TIME = np.arange(0.0, 4.0, 0.004)


def recorded(folder, jerk=0.01, described=MAP):
    """Slow sines; each take begins with a transient that is over after two rows."""
    noise, rows = np.random.default_rng(0), ["take,ms,angle,torque"]
    for take in range(3):
        fast = jerk * np.exp(-300.0 * TIME) + noise.normal(0.0, 5e-6, TIME.size)
        angle = -np.degrees(0.5 * np.sin(2.0 * TIME + take) + fast)
        torque = 0.9 * np.sin(2.0 * TIME + take)
        rows += [
            f"{take},{1e3 * t:.1f},{a:.8f},{u:.6f}"
            for t, a, u in zip(TIME, angle, torque, strict=True)
        ]
    return written(folder, rows, described)


def bench(recording):
    return axis_bench(recording, declared_axis(), groups_of(recording))


def test_its_rows_are_left_out_and_that_is_remarked(tmp_path):
    made = bench(recorded(tmp_path))
    (run,) = made.parts["fit"]
    seen = run.observed["position"]
    assert not seen.keep[: seen.windows[1]].any()
    assert seen.keep[seen.windows[1] :].all()
    said = [one for one in made.remarks if "first window is not compared" in one.what]
    assert [one.run for one in said] == ["take 0", "take 1", "take 2"]


@pytest.mark.parametrize(
    ("jerk", "described"), [(0.0, MAP), (0.01, f'{MAP}[start]\nspeed = "1 rad/s"\n')]
)
def test_what_its_rows_or_the_map_tell_is_compared(tmp_path, jerk, described):
    (run,) = bench(recorded(tmp_path, jerk, described)).parts["fit"]
    assert run.observed["position"].keep.all()
    assert BEGUN_UNTOLD not in run.notes


def test_of_two_halves_the_second_is_compared_from_its_first_row(tmp_path):
    one = MAP.replace('select = ["take 1"]', 'select = ["take 0"]')
    parts = bench(recorded(tmp_path, described=one)).parts
    assert not parts["fit"][0].observed["position"].keep[0]
    assert parts["select"][0].observed["position"].keep.all()
