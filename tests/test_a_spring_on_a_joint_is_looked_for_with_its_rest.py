"""Candidates for a device with a tip: springs of unknown rest, sizes that a survey may scale."""

import numpy as np
import pytest

from simpter_hybrid.effects.spring_force import SpringForce
from simpter_hybrid.identification.tip.candidates import tip_candidates

POSE = (1.2, 1.9)


def _named(pose=()):
    found = tip_candidates(2, 4, (30.0, 10.0), 4.0, 0.8, "tilt by joint", pose)
    return {c.name: c for c in found}


def test_each_joints_spring_has_a_rest_of_its_own_that_starts_in_the_middle_of_the_record():
    spring = _named(POSE)["spring-force"]
    values = {p.name: p.value for p in spring.parameters}
    values |= {"spring-force.1.stiffness": 2.0, "spring-force.2.rest": 1.5}
    assert spring.made(values) == (
        SpringForce(coordinate=0, stiffness=2.0, rest=1.2),
        SpringForce(coordinate=1, stiffness=0.0, rest=1.5),
    )
    # A rest says nothing without a stiffness: no fit begins at none.
    for start in spring.starts:
        named = dict(zip((p.name for p in spring.parameters), start, strict=True))
        assert all(named[name] != 0.0 for name in spring.sizes)
        assert [named[f"spring-force.{j + 1}.rest"] for j in range(2)] == list(POSE)


def test_without_a_pose_a_spring_pulls_to_zero():
    fields = [p.name for p in _named()["spring-force"].parameters]
    assert fields == ["spring-force.1.stiffness", "spring-force.2.stiffness"]


@pytest.mark.parametrize("name", ["wear-in", "thermal-fade by clutch", "stribeck", "dry-drag"])
def test_an_effect_that_is_begun_switched_on_may_begin_larger(name):
    candidate = _named(POSE)[name]
    for start in candidate.starts:
        begun = dict(zip((p.name for p in candidate.parameters), start, strict=True))
        assert len(candidate.sizes) > 0
        assert all(begun[size] != 0.0 for size in candidate.sizes)
        shapes = {"scale", "cooling", "fade"} - {candidate.sizes[0].rpartition(".")[2]}
        assert not {size.rpartition(".")[2] for size in candidate.sizes} & shapes


def test_an_effect_that_is_begun_at_nothing_has_no_size_to_scale():
    assert _named(POSE)["asymmetry"].sizes == ()
    assert np.all(np.array(_named(POSE)["asymmetry"].starts) == 0.0)
