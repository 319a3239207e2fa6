"""Which experiment separates two effects is found by simulating it."""

from dataclasses import replace

import numpy as np
import pytest
from toy_rig import ALONG_X, ALONG_Y, SCALE, ToyRig, toy_replay

from simpter_hybrid.identification.contests import contest
from simpter_hybrid.identification.fitting.fit import Fit
from simpter_hybrid.identification.fitting.fitted_model import Split, Trial, refitted
from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.identifiability_report import contested, sight
from simpter_hybrid.identification.rotor.experiments import Reach, reach_of, rotor_experiments
from simpter_hybrid.identification.rotor.signals import RotorSignals
from simpter_hybrid.identification.tracing.verdict import Verdict

#: Of a toy's torque.
NOISE = 0.1


def _like(replay: Replay, name: str, **inputs) -> Replay:
    return Replay(name, name, replay.time, {**replay.inputs, **inputs}, replay.observed)


def test_runs_in_which_two_inputs_go_together_are_told_apart_by_one_in_which_they_do_not():
    first = toy_replay("one", 1)
    x, nothing = first.inputs["x"], np.zeros(first.time.size)
    together = _like(first, "together", y=x)
    base = refitted(ToyRig(), Split([together], [together], []))
    planned = [_like(first, "again together", y=x), _like(first, "x alone", y=nothing)]
    seen = sight(base, [ALONG_X, ALONG_Y], [together], planned)
    assert [(a, b) for a, b, _ in seen.confused] == [("along x", "along y")]
    (best, distance), (_, other) = seen.run_next[("along x", "along y")]
    assert best == "x alone"
    assert distance > 10.0 > other


def test_what_no_run_moves_is_said_to_be_unseen_with_the_run_that_shows_it():
    first = toy_replay("one", 1)
    still = _like(first, "still", y=np.zeros(first.time.size))
    base = refitted(ToyRig(), Split([still], [still], []))
    seen = sight(base, [ALONG_X, ALONG_Y], [still], [still, _like(first, "one")])
    assert seen.blind == ("along y",)
    assert seen.reveals["along y"][0][0] == "one"


def test_a_share_of_a_declared_value_is_nothing_that_runs_should_show():
    first = toy_replay("one", 1)
    still = _like(first, "still", y=np.zeros(first.time.size))
    base = refitted(ToyRig(), Split([still], [still], []))
    seen = sight(base, [ALONG_X, replace(ALONG_Y, declared=True)], [still])
    assert seen.blind == ()
    assert list(seen.visible) == ["along x"]


def test_a_coordinate_that_would_do_as_well_contests_by_the_effects_that_depend_on_it():
    best = Trial(ALONG_X, None, 1.0, 0.3, 1.0)
    verdict = Verdict("cannot be told apart", best, (), (), ("friction:y",))
    assert contested(verdict, [ALONG_X, ALONG_Y]) == [("along x", "along y")]


@pytest.mark.parametrize("coupled", [True, False])
def test_every_planned_run_logs_both_torques_or_is_driven_by_one(coupled):
    reach = Reach(2.0, 9.0, 8.0, {"clutch_torque": 0.2, "motor_torque": 0.3, "speed": 0.01})
    for run in rotor_experiments(reach, coupled):
        by_torque = run.inputs["servo_mode"][0] == 1.0
        assert set(run.observed) == {"clutch_torque", "speed" if by_torque else "motor_torque"}
        assert np.abs(run.inputs["reference_speed"]).max() <= reach.speed
        assert run.inputs["command"].max() <= reach.command
        assert (run.inputs["neighbour_command"].max() > 0.0) <= coupled


def test_a_rotor_that_ran_away_under_a_torque_does_not_set_the_speed_of_planned_runs():
    def run(speed, by_torque):
        every, values = np.ones(50, bool), np.full(50, speed)
        seen = {"clutch_torque": Observation(np.ones(50), 0.1, every)}
        if by_torque:
            seen["speed"] = Observation(values, 0.01, every)
        notes, inputs = {"speed": values}, {"command": np.ones(50)}
        return Replay("run", "run", 0.01 * np.arange(50), inputs, seen, notes=notes)

    assert reach_of([run(2.0, False), run(400.0, True)], RotorSignals()).speed == 2.0
    # Where nothing was held at a speed it is all that is known.
    assert reach_of([run(3.0, True)], RotorSignals()).speed == 3.0


def test_a_rival_is_fitted_to_a_planned_run_before_a_distance_is_told():
    plan = toy_replay("x and the scale", 1)
    plan = _like(plan, "x and the scale", x=plan.inputs["u"], y=np.zeros(plan.time.size))
    base = refitted(ToyRig(), Split([plan], [plan], []))
    scaled = replace(ALONG_Y, name="along u", parameters=(replace(SCALE, name="scale"),))
    models = base.predictor.extended(ALONG_X), ToyRig((SCALE,))
    fits = [Fit({**base.values, "gain": 0.2}, 0.0, *[np.zeros(0)] * 2)]
    fits.append(Fit(dict(base.values), 0.0, *[np.zeros(0)] * 2))
    named, rival = (
        Trial(c, f, 1.0, 0.3, 1.0) for c, f in zip((ALONG_X, scaled), fits, strict=True)
    )
    ranked = ((plan.experiment, 50.0),)
    # Along x is along u here: 1.2 times the scale does what a gain of 0.2 does.
    ((_, far),) = contest(base, models, (named, rival), ranked, [plan], 1.0)
    assert far < 1.0
    # What no value of the rival does stays.
    other = _like(plan, plan.experiment, x=toy_replay("one", 1).inputs["x"])
    u, x = (other.inputs[name] for name in "ux")
    ((_, far),) = contest(base, models, (named, rival), ranked, [other], 1.0)
    alone = 0.2 * (x - u * (u @ x) / (u @ u))
    # The declared scale is known to 0.5, which 2000 samples hardly feel.
    assert far == pytest.approx(np.linalg.norm(alone) / NOISE, rel=1e-3)
    # A run that was made holds the scale: half of the way there costs as much as half of it here.
    held = _like(plan, "made", x=np.zeros(plan.time.size))
    ((_, far),) = contest(base, models, (named, rival), ranked, [plan], 1.0, [held])
    assert far == pytest.approx(0.2 * np.linalg.norm(u) / NOISE / np.sqrt(2.0), rel=1e-3)
