"""A tolerance holds a refit back: a number far beyond it is asked about, whatever it is."""

from dataclasses import replace
from types import SimpleNamespace as Some

import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.identification.benches import as_recorded, bench_of
from simpter_hybrid.identification.far_off import FarOff, far_off
from simpter_hybrid.identification.fitting.fitted_model import Split, refitted
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.reporting.cautions import far_off_sentence, in_view_of

#: Friction of all takes, over what is declared to a fifth.
TIMES = 2.5
#: Further numbers, all of them right, that are declared to a tenth.
RIGHT = {"inertia": "device.inertia", "weight": "device.weight", "drive": "load.1.constant"}


def made(folder, right=()):
    """The refitted model of takes with other friction, and their split."""
    recording = as_recorded(recorded_axis(folder, (), friction=(TIMES,) * 3))
    model = declared_axis()
    more = [{"name": n, "parameters": [RIGHT[n]], "relative": 0.1} for n in right]
    tolerances = [*model.notes["tolerances"], *more]
    model = replace(model, notes={**model.notes, "tolerances": tolerances})
    bench = bench_of(recording, model, groups_of(recording))
    split = Split(*(bench.parts[part] for part in ("fit", "select", "report")))
    return refitted(bench.predictor, split), split


@pytest.fixture(scope="module")
def asked(tmp_path_factory):
    return made(tmp_path_factory.mktemp("axis"))


def found(asked, kind="unknown", least=1.0, corrected=None):
    model, split = asked
    done = Some(refitted=model, corrected=corrected or model, verdict=Some(kind=kind))
    return far_off(done, split, least)


def test_it_is_told_with_how_far_off_it_is(asked):
    off = found(asked)
    assert off.name == "Coulomb friction"
    # Three takes on an encoder know a friction to a thousandth; a hundredth is far more.
    assert off.times == pytest.approx(TIMES, rel=0.01)
    assert off.left < 0.1
    assert "With Coulomb friction 2.5 times as declared" in far_off_sentence(off)
    assert in_view_of({}, "Nothing is missing.", off=off) == (
        "If the declared numbers are right: nothing is missing."
    )


def test_numbers_that_are_right_are_not_accused_beside_it(tmp_path):
    off = found(made(tmp_path, RIGHT))
    assert off.name == "Coulomb friction"
    # A gain of all of them at once shows in no motion: within their tolerances they may move.
    assert off.times == pytest.approx(TIMES, rel=0.3)


def test_nobody_asks_where_an_effect_explains_it_or_little_is_left(asked):
    assert found(asked, kind="effect") is None
    assert found(asked, least=1e9) is None
    # But beside an effect if a number was refitted as far as it may be.
    model, _ = asked
    (friction,) = [p for p in model.predictor.parameters if p.name == "Coulomb friction"]
    ended = replace(model, values={**model.values, friction.name: friction.upper})
    assert found(asked, kind="effect", corrected=ended).name == friction.name
    # Nor where what was found leaves far less.
    assert found(asked, corrected=Some(select_error=1e-3)) is None


def test_others_that_leave_about_as_little_are_told_beside_it(tmp_path, monkeypatch):
    made_so = made(tmp_path, RIGHT)
    explained = Some(select_error=0.2 * made_so[0].select_error)
    left = {"inertia": 18, "drive": 23, "Coulomb friction": 35, "weight": 37}
    module = "simpter_hybrid.identification.far_off._without_tolerance"
    monkeypatch.setattr(module, lambda _, p, __: FarOff(p.name, 10.0, left[p.name] / 100.0))
    off = found(made_so, corrected=explained)
    said = far_off_sentence(off)
    assert "With inertia 10 times as declared 18 % of the refitted model's error is left" in said
    assert said.endswith("is left, or with drive 10 times as declared 23 % "
                         "or with Coulomb friction 10 times as declared 35 %.")  # fmt: skip
    left |= {"drive": 37}  # over twice what is left with the inertia
    others = found(made_so, corrected=explained).others
    assert [one.name for one in others] == ["Coulomb friction"]
