"""A flywheel spins down under a brake whose coil current is logged: the brake follows it late."""

from dataclasses import replace

import numpy as np
import pytest
from axis_recordings import MAP, written
from axis_recordings import MODEL as DRIVEN

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.axis.pressed import lag_off, pressed_candidates
from simpter_hybrid.identification.axis.recorded import as_axis
from simpter_hybrid.identification.benches import bench_of
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.recordings.groups import groups_of

INERTIA, DRAG, BRAKE, STEP, ROW, LASTS = 0.02, 0.01, 0.2, 1e-4, 5e-3, 4.0
NOISE_OF_SPEED, NOISE_OF_CURRENT = 0.03, 0.002
DECLARED = parse(
    (DRIVEN[: DRIVEN.index("[[loads]]")] + DRIVEN[DRIVEN.index("[[tolerances]]") :])
    .replace('weight = "0.5 N*m"\n', "").replace("0.2 N*m", "0.01 N*m")
    .replace('viscous = "0.02 N*m*s/rad"', 'viscous = "0 N*m*s/rad", normal = "0.2 N*m/V"')
)  # fmt: skip
SPUN = (
    "driven = false\n"
    + MAP.partition("[channels.position]")[0]
    + """
[channels.speed]
column = "rate"
unit = "rad/s"
sign = 1
role = "measured"
may_rest = true
[channels.command]
column = "coil"
unit = "V"
sign = 1
role = "input"
"""
)
GROUPS = {"fit": ("take 0",), "select": ("take 1",), "report": ("take 2",)}
LATE = replace(DECLARED, clutches=(replace(DECLARED.clutches[0], time_constant=0.03),))
TRIED = ("press-lag", "press-scale", "quadratic-drag", "stribeck", "drift")


def current(time, run):
    return 0.5 + 0.4 * np.sign(np.sin(2 * np.pi * time / (0.9 + 0.2 * run)))


def spun(run, lag):
    """Speed and coil current (samples, 2) by small steps."""
    speed, at = 80.0 + 20.0 * run, float(current(0.0, run))
    rows = []
    for k in range(round(LASTS / STEP)):
        coil = float(current(k * STEP, run))
        rows.append((speed, coil))
        at = coil if lag == 0.0 else at + STEP * (coil - at) / lag
        speed = max(0.0, speed - STEP * (DRAG + BRAKE * at) / INERTIA)
    return np.array(rows)[:: round(ROW / STEP)]


def recorded(folder, lag):
    generator, rows = np.random.default_rng(9), ["take,ms,rate,coil"]
    for run in range(3):
        for k, (speed, coil) in enumerate(spun(run, lag)):
            seen = speed + NOISE_OF_SPEED * generator.standard_normal()
            sensed = coil + NOISE_OF_CURRENT * generator.standard_normal()
            rows.append(f"{run},{1e3 * ROW * k:.0f},{seen:.4f},{sensed:.5f}")
    return as_axis(written(folder, rows, SPUN))


@pytest.mark.slow
@pytest.mark.parametrize("lag", [0.0, 0.06])
def test_it_is_named_and_none_is_not(tmp_path, lag):
    recording = recorded(tmp_path, lag)
    bench = bench_of(recording, DECLARED, groups_of(recording))
    done = diagnose(recording, DECLARED, [c for c in bench.candidates if c.name in TRIED]).search
    assert [e.name for e in done.corrected.effects] == (["press-lag"] if lag else [])
    if lag:  # a jump of the current is known to a row of the record
        assert done.corrected.values["press-lag.lag"] == pytest.approx(lag, abs=ROW)
    else:
        assert done.verdict.kind == "nothing missing"


def test_what_does_not_change_within_runs_tells_of_no_memory(tmp_path):
    replays = bench_of(recorded(tmp_path, 0.0), DECLARED, GROUPS).parts["fit"]
    assert {c.name for c in pressed_candidates(replays)} >= {"press-lag", "press-hysteresis"}
    for steady, names in ((0.5, ["press-scale", "press-power"]), (0.0, [])):
        for replay in replays:
            replay.inputs["press"][:] = steady
        assert [c.name for c in pressed_candidates(replays)] == names


@pytest.mark.slow
def test_a_declared_lag_that_is_twice_as_long_is_told_as_such(tmp_path):
    recording, names = recorded(tmp_path, 0.06), (*TRIED, "time-constant")
    bench = bench_of(recording, LATE, groups_of(recording))
    done = diagnose(recording, LATE, [c for c in bench.candidates if c.name in names]).search
    assert [e.name for e in done.corrected.effects] == ["time-constant"]
    found = 0.03 * (1.0 + done.corrected.values["time-constant.share"])
    assert found == pytest.approx(0.06, abs=ROW)


def test_a_lag_that_is_not_declared_or_that_no_run_shows_is_not_off(tmp_path):
    replays = bench_of(recorded(tmp_path, 0.0), DECLARED, GROUPS).parts["fit"]
    assert [c.name for c in lag_off(LATE, replays)] == ["time-constant"]
    assert lag_off(DECLARED, replays) == ()
    for replay in replays:
        replay.inputs["press"][:] = 0.5
    assert lag_off(LATE, replays) == ()
