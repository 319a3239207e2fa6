"""A weight or a spring of the model is elsewhere where the position's zero is: no motion tells."""

from types import SimpleNamespace

import pytest
from axis_recordings import declared_axis, recorded_axis
from coarse_force import moved_bench

from simpter_hybrid.identification.benches import bench_of
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.reporting.sentences import class_sentence
from simpter_hybrid.identification.rigs.corrected import with_parameters


@pytest.mark.parametrize(("weight", "zero"), [(0.5, True), (0.0, False)])
def test_it_is_said_where_something_pulls_back(tmp_path, weight, zero):
    recording = recorded_axis(tmp_path, [])
    declared = with_parameters(declared_axis(), {"device.weight": weight})
    bench = bench_of(recording, declared, groups_of(recording))
    named = [c for c in bench.candidates if c.name in ("bias-force", "imbalance", "viscous-drag")]
    done = SimpleNamespace(corrected=SimpleNamespace(effects=named))
    said = class_sentence(SimpleNamespace(search=done))
    pulled = ", or the zero of the position" if zero else ""
    assert (
        f"bias-force (a constant force): load, or the offset of the drive's sensor{pulled}" in said
    )
    imbalance = "imbalance (weight off the axis)"
    assert f"{imbalance}: load{pulled}." in said or f"{imbalance}: load{pulled}," in said
    assert "viscous-drag (drag in proportion to speed): load," in said


def test_a_testers_force_has_a_zero_too(tmp_path):
    named = {c.name: c.acts_on for c in moved_bench(tmp_path, 0.4).candidates}
    assert named["bias-force"] == "load, or the zero of the force sensor"
    assert named["viscous-drag"] == "load"
