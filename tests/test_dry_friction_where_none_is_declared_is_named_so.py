"""Of no friction no factor makes any: where a model declares none, a level of it is looked for."""

from dataclasses import replace

import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.identification.axis.candidates import with_friction_scale
from simpter_hybrid.identification.benches import bench_of
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.fitting.fitted_model import Trial
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.tracing.rivals import best_form

pytest.importorskip("llvmlite")
NAMES = ("dry-friction", "asymmetry-level", "viscous-drag", "bias-force")


def without_friction():
    declared = declared_axis()
    none = replace(declared.clutches[0].torque, coulomb=0.0)
    return replace(declared, clutches=(replace(declared.clutches[0], torque=none),))


@pytest.fixture(scope="module")
def tried(tmp_path_factory):
    recording = recorded_axis(tmp_path_factory.mktemp("axis"), (), rate_noise=0.01)
    found = bench_of(recording, without_friction(), groups_of(recording)).candidates
    return recording, {c.name: c for c in found}


def test_it_is_named_with_its_size(tried):
    recording, known = tried
    done = diagnose(recording, without_friction(), [known[name] for name in NAMES]).search
    assert [effect.name for effect in done.corrected.effects] == ["dry-friction"]
    law = done.corrected.predictor.scenario(done.corrected.values).clutches[0].torque
    # As of another scale: half widths of some 0.3 % of the 0.2 N m with which it was made.
    assert law.coulomb == pytest.approx(0.2, rel=0.01)


@pytest.mark.parametrize(("dry", "named"), [(0.5001, "dry-friction"), (0.502, "asymmetry-level")])
def test_one_direction_alone_tells_no_difference_between_two(tried, dry, named):
    left = {"dry-friction": dry, "asymmetry-level": 0.5}
    trials = [Trial(tried[1][name], None, x, 1 - x, 1.0) for name, x in left.items()]
    assert best_form(trials).candidate.name == named


def test_it_is_looked_for_only_where_none_is_declared():
    assert [c.name for c in with_friction_scale((), without_friction(), 1.0)] == ["dry-friction"]
    assert [c.name for c in with_friction_scale((), declared_axis(), 1.0)] == ["friction-scale"]
