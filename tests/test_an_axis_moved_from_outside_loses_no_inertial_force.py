"""A heavy coordinate is moved to and fro: what its inertia takes is known, and nothing is left."""

from dataclasses import replace

import numpy as np
import pytest
from moved_axis import MAP, model

from simpter_hybrid.effects.added_inertia import AddedInertia
from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.axis.force_sensor import shown
from simpter_hybrid.identification.axis.prescribed_replays import CLEARER, prescribed_replays
from simpter_hybrid.identification.axis.prescribed_rig import PrescribedRig
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.problems import InvalidInput

MASS, VISCOUS, STEP = 3.0, 8.0, 0.005
MODEL = model(MASS, f'coulomb = "2 N", viscous = "{VISCOUS} N*s/m"')


def _motion():
    """Time, position, speed and acceleration of 1.4 Hz: 75 ms of it are a tenth of a turn."""
    t, turn = np.arange(0.0, 8.0, STEP), 2 * np.pi * 1.4
    x = 0.03 * np.sin(turn * t + 0.3)  # no row at rest, where friction may be anything
    return t, x, 0.03 * turn * np.cos(turn * t + 0.3), -(turn**2) * x


def test_the_force_is_that_of_inertia_and_friction_at_each_sample(tmp_path):
    t, x, v, a = _motion()
    force = MASS * a + 2.0 * np.sign(v) + VISCOUS * v
    rows = [
        "run,t,x,F",
        *(f"0,{i:.3f},{j:.9f},{k:.6f}" for i, j, k in zip(t, x, force, strict=True)),
    ]
    (tmp_path / "data.csv").write_text("\n".join(rows), encoding="utf-8")
    (tmp_path / "map.toml").write_text(MAP, encoding="utf-8")
    (replay,) = prescribed_replays(load_recording(tmp_path / "data.csv", tmp_path / "map.toml"))
    told = ScenarioPredictor(parse(MODEL), PrescribedRig()).predict({"Coulomb": 1.0}, [replay])
    seen = replay.observed["force"]
    left = (seen.values - told["force"][0])[seen.keep]
    # Inertia takes up to 7 N, drag changes by up to 0.1 N from one sample to the next: of neither
    # a thousandth is lost (quartics over 75 ms lose 1e-4).
    assert np.abs(left).max() < 1e-3 * MASS * np.abs(a).max()


def test_what_is_added_to_the_inertia_takes_force_as_well():
    t, x, _, a = _motion()
    notes = {"position": x, "speed": np.gradient(x, STEP), "acceleration": a}
    notes[CLEARER] = np.zeros(t.size, dtype=bool)
    seen = {"force": Observation(np.zeros(t.size), 1.0, np.ones(t.size, dtype=bool))}
    inputs = {"press": np.zeros(t.size)}
    replay = Replay("run", "run", t, inputs, seen, drive_is_exact=False, notes=notes)
    heavier = replace(parse(MODEL), effects=(AddedInertia(inertia_change=0.5, coordinate=0),))
    forces = [
        ScenarioPredictor(model, PrescribedRig()).predict({"Coulomb": 1.0}, [replay])["force"][0]
        for model in (parse(MODEL), heavier)
    ]
    # The bulk of 1e9 kg leaves 1e-7 N of rounding.
    assert forces[1] - forces[0] == pytest.approx(0.5 * a, abs=1e-5)


@pytest.mark.parametrize("clearer", [False, True])
@pytest.mark.parametrize("error", [{"force-delay.delay": 0.0123}, {"force-lag.lag": 0.009}])
def test_a_late_sensor_is_the_same_whichever_side_is_put_right(error, clearer):
    t, x, v, a = _motion()
    force = MASS * a + 2.0 * np.sign(v) + VISCOUS * v
    seen = Observation(shown(t, force, error), 1.0, np.abs(v) > 0.2 * v.max())
    notes = {"position": x, "speed": v, "acceleration": a}
    notes[CLEARER] = np.full(t.size, clearer)
    replay = Replay("run", "run", t, {"press": np.zeros(t.size)}, {"force": seen},
                    drive_is_exact=False, notes=notes)  # fmt: skip
    told = ScenarioPredictor(parse(MODEL), PrescribedRig()).predict(
        {"Coulomb": 1.0, **error}, [replay]
    )
    left = (seen.values - told["force"][0])[seen.keep][50:-50]
    # Of 7 N a hundredth: differences over two rows of 5 ms at 1.4 Hz lose 3e-4 of a slope, means
    # between rows 5e-4; without the error 0.9 N would be left.
    assert np.abs(left).max() < 0.07


def test_runs_of_which_nothing_can_be_compared_are_refused(tmp_path):
    t, x, _, _ = _motion()
    rows = ["run,t,x,F"]
    for run in range(3):
        force = (1.0 + run) * x
        rows += [
            f"{run},{i:.3f},{j:.9f},{k:.9f}"
            for i, j, k in zip(t[:60], x[:60], force[:60], strict=True)
        ]
    (tmp_path / "data.csv").write_text("\n".join(rows), encoding="utf-8")
    (tmp_path / "map.toml").write_text(MAP, encoding="utf-8")
    recording = load_recording(tmp_path / "data.csv", tmp_path / "map.toml")
    with pytest.raises(
        InvalidInput, match=r"too little of the runs that fit can be compared; left out are \d+ \w+"
    ):
        diagnose(recording, parse(MODEL))
