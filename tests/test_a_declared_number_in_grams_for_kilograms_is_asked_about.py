"""A number that a prefix puts off by a hundred or a thousand is beyond what a fit steps to."""

from dataclasses import replace
from types import SimpleNamespace as Some

import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.identification.benches import as_recorded, bench_of
from simpter_hybrid.identification.far_off import far_off
from simpter_hybrid.identification.fitting.fitted_model import Split, refitted
from simpter_hybrid.identification.recordings.groups import groups_of


@pytest.mark.parametrize(("times", "relative"), [(1e3, 0.1), (1e-2, 0.1), (1e3, 0.5)])
def test_its_factor_is_told(tmp_path, times, relative):
    recording, model = as_recorded(recorded_axis(tmp_path, ())), declared_axis()
    heavy = replace(model.device, inertia=times * model.device.inertia)
    inertia = {"name": "inertia", "parameters": ["device.inertia"]}
    inertia["relative"] = relative
    notes = {**model.notes, "tolerances": [*model.notes["tolerances"], inertia]}
    bench = bench_of(recording, replace(model, device=heavy, notes=notes), groups_of(recording))
    split = Split(*(bench.parts[part] for part in ("fit", "select", "report")))
    model = refitted(bench.predictor, split)
    off = far_off(Some(refitted=model, corrected=model, verdict=Some(kind="unknown")), split, 1.0)
    assert off.name == "inertia"
    # Three takes on an encoder know the inertia to a thousandth; the friction moves along with it.
    assert off.times == pytest.approx(1.0 / times, rel=0.02)
    assert off.left < 0.1
