"""What one curve takes away whole depends on its coordinate, however many go along with it."""

from types import SimpleNamespace as Some

import pytest
from asked_curves import concluded

from simpter_hybrid.identification.reporting import lack_sentences
from simpter_hybrid.identification.tracing.verdict import Verdict

#: As residual forces show them: what pulls on one slide of two moves both.
WHERE = ("joint_1:slip_velocity", "joint_2:slip_velocity", "joint_2:speed", "joint_2:position")
PLACE = "joint_2:position"
BEFORE = Some(select_error=3.1, values={}, predictor=Some(parameters=()), effects=())


def curve(left, share=0.98, alike=(PLACE,), coordinate=PLACE):
    return Some(
        coordinate=coordinate, alike=alike, trial=Some(select_error=left, share=share, gain=0.7)
    )


def told(monkeypatch, known, where=WHERE, kind="unknown"):
    models = (BEFORE, BEFORE)
    verdict = Verdict(kind, coordinates=where)
    return concluded(monkeypatch, verdict, models, known, "", None).verdict.coordinates


def test_that_coordinate_alone_is_what_it_depends_on(monkeypatch):
    assert told(monkeypatch, curve(0.95)) == (PLACE,)


def test_one_over_which_a_curve_does_nearly_as_well_is_told_behind_it(monkeypatch):
    known = curve(0.95, alike=(PLACE, "joint_2:speed"))
    assert told(monkeypatch, known) == (PLACE, "joint_2:speed")


@pytest.mark.parametrize("known", [curve(1.15), curve(0.95, share=0.7), None])
def test_where_no_curve_takes_all_away_all_are_told(monkeypatch, known):
    assert told(monkeypatch, known) == WHERE


def test_a_form_that_is_incomplete_leaves_what_it_leaves(monkeypatch):
    assert told(monkeypatch, curve(0.95), kind="form incomplete") == WHERE


def test_of_a_rotor_the_other_balance_and_breakaways_stay(monkeypatch):
    where = ("load:time", "friction:torque", "load:torque", "breakaway:dwell", "friction:heat")
    known = curve(0.95, alike=("friction:torque",), coordinate="friction:torque")
    assert told(monkeypatch, known, where) == ("friction:torque", "load:torque", "breakaway:dwell")


@pytest.mark.parametrize(("left", "others"), [(0.95, False), (1.3, True)])
def test_others_that_go_along_are_told_beside_a_curve_that_leaves_more(monkeypatch, left, others):
    monkeypatch.setattr(lack_sentences, "among_others", lambda *given: ", among others (x)")
    for name in ("nearest_text", "_not_held_out"):
        monkeypatch.setattr(lack_sentences, name, lambda found: "")
    search = Some(
        verdict=Verdict("unknown", coordinates=(PLACE,)), corrected=BEFORE, floor=1.0, rounds=()
    )
    limits = Some(form=1.05, estimated=False)
    found = Some(search=search, limits=limits, empirical=curve(left), taken_back=None)
    assert ("among others" in lack_sentences.lack_sentence(found)) == others
