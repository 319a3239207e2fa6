"""The sentence of a verdict whose first-round rival became the second effect."""

from types import SimpleNamespace

import pytest

from simpter_hybrid.identification.fitting.floor import Floors
from simpter_hybrid.identification.reporting.sentences import verdict_sentence
from simpter_hybrid.identification.tracing.limits import Limits
from simpter_hybrid.identification.tracing.verdict import Verdict


def tried(name, shares=(), **values):
    """As much of a trial as the sentence needs."""
    candidate = SimpleNamespace(name=name, family=name, at=(), declared=bool(shares), shares=shares)
    return SimpleNamespace(candidate=candidate, fit=SimpleNamespace(values=values))


def found(effects, rivals, error, left=()):
    """As much of a diagnosis; floor 1; the rivals are the first effect's."""
    kept = tuple(t for t in rivals if t.candidate.name not in effects)
    kind = "cannot be told apart" if kept else "form incomplete"
    first = Verdict("cannot be told apart", tried(effects[0]), tuple(rivals))
    later = [Verdict("effect", tried(n)) for n in effects[1:]]
    model = SimpleNamespace(
        values={}, effects=[tried(n).candidate for n in effects], select_error=error
    )
    after = {"friction": [SimpleNamespace(coordinate="speed", gain=0.254)]}
    rounds = tuple(
        SimpleNamespace(verdict=v, trials=(), before={}, after=after) for v in (first, *later)
    )
    verdict = Verdict(kind, first.accepted, kept, left)
    groups = [{"name": "Coulomb", "parameters": ["clutch.1.torque.coulomb"]}]
    declared = SimpleNamespace(notes={"tolerances": groups})
    refitted = SimpleNamespace(predictor=SimpleNamespace(declared=declared))
    done = SimpleNamespace(
        verdict=verdict, refitted=refitted, corrected=model, floor=1.0, rounds=rounds
    )
    ladder, floors = {"after": error}, Floors(1.0, 1.0, 1.0)
    return SimpleNamespace(
        search=done, limits=Limits(), levels=None, error_by_stage=ladder, floors=floors, forms={}
    )


def test_a_rival_that_was_added_later_is_not_named_as_one():
    said = verdict_sentence(found(["asymmetry", "bias-force"], [tried("bias-force")], 14.0))
    assert "exclude" not in said
    assert "incomplete" in said
    assert "14.00" in said


def test_a_rival_that_was_not_added_is_named_with_the_effect_it_rivals():
    said = verdict_sentence(found(["stribeck", "imbalance"], [tried("drag")], 1.0))
    assert "do not exclude drag in place of stribeck" in said


@pytest.mark.parametrize(("refit", "said"), [(1.0, "0.14"), (1.7, "0.238")])
def test_of_a_declared_number_that_would_do_it_says_how_far_off_it_is(refit, said):
    shares = (("friction-scale.share", "clutch.1.torque.coulomb"),)
    scale = tried("friction-scale", shares, **{"friction-scale.share": -0.86, "Coulomb": refit})
    told = verdict_sentence(found(["stribeck"], [scale], 1.0))
    assert f"do not exclude friction-scale ({said} times as declared) in place" in told


def test_what_goes_along_with_a_coordinate_beside_a_rival_is_said_at_the_floor_too():
    told = verdict_sentence(found(["sensor"], [tried("motor")], 1.0, ("friction:speed",)))
    assert told.endswith(
        "What is left is as large as noise, but goes along with speed (friction, actuator or "
        "torque sensor) (25.4 % of its mean square)."
    )
    assert "What is left" not in verdict_sentence(found(["sensor"], [tried("motor")], 1.0))
