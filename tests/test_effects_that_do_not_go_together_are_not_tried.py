from dataclasses import replace

import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.effects.dahl import Dahl
from simpter_hybrid.identification.axis.candidates import axis_candidates
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.axis.sizes import AxisSizes
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor


def test_friction_by_load_and_presliding_exclude_each_other():
    # One size of everything: only the wiring is asked.
    known = {c.name: c for c in axis_candidates(AxisSizes(1.0, 1.0, 1.0, 1.0, 1.0, False))}
    alone = ScenarioPredictor(declared_axis(), AxisRig())
    assert alone.combines(known["presliding"])
    assert alone.combines(known["load-dependent"])
    assert not alone.extended(known["load-dependent"]).combines(known["presliding"])
    assert not alone.extended(known["presliding"]).combines(known["load-dependent"])


def test_friction_that_is_solved_for_as_a_whole_stays_last():
    known = {c.name: c for c in axis_candidates(AxisSizes(1.0, 1.0, 1.0, 1.0, 1.0, False))}
    loaded = ScenarioPredictor(declared_axis(), AxisRig()).extended(known["load-dependent-rotor"])
    assert loaded.combines(known["stribeck"])
    both = loaded.extended(known["stribeck"])
    assert [e.name for e in both.effects] == ["stribeck", "load-dependent-rotor"]
    values = {p.name: p.value for p in both.parameters} | {"stribeck.rise": 0.3}
    assert [type(e).__name__ for e in both.scenario(values).effects] == ["Stribeck", "RotorLoad"]


@pytest.mark.slow
def test_a_model_that_declares_presliding_is_diagnosed_and_says_what_is_left_out(tmp_path):
    effect, said = Dahl(clutch=0, displacement=0.02), []
    declared = replace(declared_axis(), effects=(effect,))
    found = diagnose(recorded_axis(tmp_path, [effect]), declared, say=said.append)
    assert found.search.verdict.kind == "nothing missing"
    left_out = "do not go with what is declared: presliding, presliding-2, load-dependent"
    assert any(left_out in s for s in said)
