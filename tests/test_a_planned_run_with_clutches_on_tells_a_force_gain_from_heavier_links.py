"""With all clutches off a force read too large is the same as links too light."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.identification.fitting.predictor import Parameter
from simpter_hybrid.identification.identifiability_report import sight
from simpter_hybrid.identification.maps import MAPS, find_model
from simpter_hybrid.identification.recordings.map_file import read_map
from simpter_hybrid.identification.recordings.recording import Recording
from simpter_hybrid.identification.rigs.effect_candidate import EffectCandidate
from simpter_hybrid.identification.rigs.pose import evaluated
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.identification.tip.experiments import TipReach
from simpter_hybrid.identification.tip.plan import planned_recording, tip_reach
from simpter_hybrid.identification.tip.rig import TipRig, tip_replays

INERTIAS = ("alpha", "beta", "gamma")


def _candidate(name, fields, shifts=()):
    own = tuple(Parameter(f"{name}.{f}", 0.0, -0.5, 0.5, 0.01) for f in fields)
    return EffectCandidate(name, own, ((0.0,) * len(own),), name, "load", (), shifts=shifts)


@pytest.fixture(scope="module")
def rig():
    declared = load(find_model("robot"))
    known = declared.device.parameters()
    heavier = _candidate(
        "heavier", ["share"], tuple(("heavier.share", f"device.{k}", known[k]) for k in INERTIAS)
    )
    reach = TipReach(
        np.array(declared.q), np.array([0.3, 0.4]), np.array([0.7, 0.9]),
        evaluated(declared, "clutch_map", np.array(declared.q), (4, 2)), 80.0,
        np.array([5.0] * 4), 3.0, 4e-3,
    )  # fmt: skip
    blank = Recording("", read_map(MAPS / "robot.toml"), ())
    future, _ = planned_recording(blank, declared, reach)
    predictor = ScenarioPredictor(declared, TipRig())
    base = SimpleNamespace(
        predictor=predictor, values={p.name: p.value for p in predictor.parameters}
    )
    return declared, base, [_candidate("force-gain", "xy"), heavier], future, reach


def test_the_recommended_run_has_a_clutch_on_and_tells_more_than_the_recorded_ones(rig):
    _, base, candidates, future, _ = rig
    runs = tip_replays(future)
    free = [r for r in runs if "clutches off" in r.experiment]
    seen = sight(base, candidates, free, runs)
    assert [(a, b) for a, b, _ in seen.confused] == [("force-gain", "heavier")]
    (best, distance), *_ = seen.run_next["force-gain", "heavier"]
    recorded = sight(base, candidates, free).run_next["force-gain", "heavier"]
    assert "clutches off" not in best
    # A force that reads 3 % too large: links 3 % too light but for the square, one in thirty.
    assert distance > 5.0 * recorded[0][1]


def test_planned_runs_push_and_move_no_more_than_the_reach(rig):
    declared, _, _, future, reach = rig
    replays = tip_replays(future)
    again = tip_reach(declared, replays)
    # The arm gives way at the largest force; four standard deviations of its sensor's noise.
    assert again.force <= reach.force + 4 * 0.25
    assert np.all(again.span <= 1.3 * reach.span)
    assert np.all(again.speed <= 1.3 * reach.speed)
    assert np.all(again.commands <= reach.commands)


def test_a_plan_is_the_same_each_time(rig):
    declared, _, _, future, reach = rig
    again, laid_down = planned_recording(replace(future, runs=()), declared, reach)
    assert list(laid_down) == [run.name for run in again.runs]
    for one, other in zip(future.runs, again.runs, strict=True):
        assert one.name == other.name
        assert all(np.array_equal(one.channels[c], other.channels[c]) for c in one.channels)
