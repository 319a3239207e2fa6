"""A pendulum is let go and its angle filmed: half a second of it tells nothing of a weak drag."""

import numpy as np
import pytest
from axis_recordings import MAP, written
from axis_recordings import MODEL as DRIVEN

from simpter_hybrid.identification.axis.recorded import as_axis
from simpter_hybrid.identification.axis.replays import AxisSignals, axis_replays
from simpter_hybrid.identification.benches import bench_of
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.fitting.replay import in_windows
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.scenario_file import parse

INERTIA, WEIGHT, COULOMB, VISCOUS, NOISE = 0.02, 0.5, 0.005, 0.001, 2e-3
STEP, ROW, LASTS = 1e-3, 0.02, 8.0
#: A tenth heavier than it is: over a whole run that turns oscillations upside down.
DECLARED = parse(
    (DRIVEN[: DRIVEN.index("[[loads]]")] + DRIVEN[DRIVEN.index("[[tolerances]]") :])
    .replace("0.2 N*m", "0.005 N*m").replace("0.02 N*m*s", "0.001 N*m*s")
    .replace("0.02 kg", "0.022 kg").replace("relative = 0.2", "relative = 0.5")
    + '[[tolerances]]\nname = "inertia"\nparameters = ["device.inertia"]\nrelative = 0.1\n'
)  # fmt: skip
TRIED = ("quadratic-drag", "viscous-drag", "stribeck", "asymmetry", "spring-force", "drift")
LET_ALONE = "driven = false\n" + MAP.partition("[channels.torque]")[0]


def swung(first, drag):
    """Angles (samples,) by steps of Heun; friction stops it where it can."""

    def slowed(angle, speed):
        dry = COULOMB * np.sign(speed) + VISCOUS * speed + drag * speed * abs(speed)
        return -(WEIGHT * np.sin(angle) + dry) / INERTIA

    angle, speed, angles = first, 0.0, []
    for _ in range(round(LASTS / STEP)):
        angles.append(angle)
        a = slowed(angle, speed)
        b = slowed(angle + STEP * speed, speed + STEP * a)
        held = abs(WEIGHT * np.sin(angle)) < COULOMB
        after = speed + 0.5 * STEP * (a + b)
        angle += 0.5 * STEP * (speed + after)
        speed = 0.0 if held and after * speed <= 0.0 else after
    return np.array(angles)[:: round(ROW / STEP)]


def filmed(folder, drag):
    generator, rows = np.random.default_rng(5), ["take,ms,angle"]
    for run, first in enumerate((1.0, -0.5, 0.8, -1.2)):
        angle = swung(first, drag)
        seen = angle + NOISE * generator.standard_normal(angle.size)
        rows += [f"{run},{1e3 * ROW * k:.0f},{-np.degrees(q):.5f}" for k, q in enumerate(seen)]
    return written(folder, rows, LET_ALONE)


@pytest.mark.parametrize("drag", [0.0, pytest.param(0.001, marks=pytest.mark.slow)])
def test_a_weak_drag_is_named_and_none_is_not(tmp_path, drag):
    recording = as_axis(filmed(tmp_path, drag))
    library = bench_of(recording, DECLARED, groups_of(recording)).candidates
    tried = [c for c in library if c.name in TRIED]
    done = diagnose(recording, DECLARED, tried).diagnosis
    named = [e.name for e in done.corrected.effects]
    assert named == (["quadratic-drag"] if drag else [])
    if drag:
        found = next(v for k, v in done.corrected.values.items() if k.startswith("quadratic-drag"))
        # Weight over inertia is all that a swing shows: sizes go with the inertia.
        scale = done.corrected.values["inertia"] * 0.022 / INERTIA
        assert found / scale == pytest.approx(drag, rel=0.1)


def test_what_is_compared_is_one_window_and_what_is_traced_many(tmp_path):
    replay = axis_replays(as_axis(filmed(tmp_path, 0.0)), AxisSignals())[0]
    assert (replay.restarts, replay.observed["position"].windows) == ((), (0,))
    cut = in_windows(replay)
    assert cut.restarts == replay.followed
    assert len(cut.observed["position"].windows) == round(LASTS / 0.5)
    assert cut.observed["position"].lines
