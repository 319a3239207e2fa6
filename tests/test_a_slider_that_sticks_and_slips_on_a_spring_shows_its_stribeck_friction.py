"""A spring pulls a slider: a slip that begins a moment early has all later ones early.

Set anew from the record every half second a fit finds what whole runs show only from nearby.
"""

import numpy as np
import pytest
from axis_recordings import MAP, MODEL, written

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.axis.recorded import as_axis
from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.benches import bench_of
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.recordings.groups import groups_of

MASS, SPRING, COULOMB, VISCOUS, RISE, FADE = 1.0, 2000.0, 4.0, 2.0, 0.4, 0.008
NOISE, STEP, ROW, LASTS = 2e-6, 1e-4, 2e-3, 3.0
DRIVE = MODEL[MODEL.index("[[loads]]") : MODEL.index("[[tolerances]]")]
PULL = """[[loads]]
kind = "pulled-spring"
points = [["0 s", "0 m"], ["1 s", "1 m"]]
stiffness = "2000 N/m"
"""
DECLARED = parse(
    MODEL.replace('"one-axis"', '"linear-axis"').replace('inertia = "0.02 kg*m^2"', 'mass = "1 kg"')
    .replace('weight = "0.5 N*m"\n', "").replace('coordinates = ["0 rad"]', 'coordinates = ["0 m"]')
    .replace("0.2 N*m", "4 N").replace("0.02 N*m*s/rad", "2 N*s/m").replace(DRIVE, PULL)
)  # fmt: skip
TOLD = MAP.partition("[channels.torque]")[0].replace('"deg"', '"mm"').replace("-1", "1")
TOLD += '[channels.reference]\ncolumn = "told"\nunit = "mm"\nsign = 1\nrole = "input"\n'
TRIED = ("stribeck", "asymmetry", "drift")


def pulled(pace):
    """Where the spring's end and the slider are (samples, 2)."""
    at, speed, rows = 0.0, 0.0, []
    for k in range(round(LASTS / STEP)):
        end = pace * min(k * STEP, LASTS - k * STEP)
        rows.append((end, at))
        level = COULOMB * (1.0 + RISE * np.exp(-abs(speed) / FADE)) * STEP / MASS
        free = speed + STEP * (SPRING * (end - at) - VISCOUS * speed) / MASS
        after = np.sign(free) * max(abs(free) - level, 0.0)
        after = 0.0 if after * speed < 0.0 else after
        at, speed = at + 0.5 * STEP * (speed + after), after
    return np.array(rows)[:: round(ROW / STEP)]


def recorded(folder):
    generator, rows = np.random.default_rng(3), ["take,ms,angle,told"]
    for run, pace in enumerate((0.01, 0.006, 0.014)):
        for k, (end, at) in enumerate(1e3 * pulled(pace)):
            seen = at + 1e3 * NOISE * generator.standard_normal()
            rows.append(f"{run},{1e3 * ROW * k:.0f},{seen:.5f},{end:.5f}")
    return written(folder, rows, TOLD)


@pytest.mark.slow
def test_it_is_found_though_no_small_step_from_none_lowers_the_error(tmp_path):
    recording = recorded(tmp_path)
    bench = bench_of(recording, DECLARED, groups_of(recording))
    found = diagnose(recording, DECLARED, [c for c in bench.candidates if c.name in TRIED])
    done = found.search
    assert [e.name for e in done.corrected.effects] == ["stribeck"]
    # Peaks of a slip of 2 mm stand still within a tenth of a millisecond, one step of this test.
    assert abs(done.corrected.values["stribeck.rise"] / RISE - 1.0) < 0.02


def test_its_runs_are_set_anew_in_windows(tmp_path):
    (replay, *_) = axis_replays(as_axis(recorded(tmp_path)), AxisSignals(anew=True))
    assert len(replay.restarts) == LASTS / 0.5 - 1
    # A slip is far more than a start's error: no line is taken away.
    assert not replay.observed["position"].lines


def test_a_servo_of_its_own_is_followed_over_the_whole_run(tmp_path):
    (replay, *_) = axis_replays(as_axis(recorded(tmp_path)), AxisSignals())
    assert not replay.restarts
    assert len(replay.followed) == LASTS / 0.5 - 1
    assert replay.observed["position"].windows == (0,)
