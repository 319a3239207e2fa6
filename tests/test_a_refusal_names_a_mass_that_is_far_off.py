"""A model that errs more than rest: the mass is named by the factor that brings it back."""

from dataclasses import replace

import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.identification import hopeless
from simpter_hybrid.identification.benches import as_recorded, bench_of
from simpter_hybrid.identification.deviations import scaled
from simpter_hybrid.identification.hopeless import refuse_hopeless
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.problems import InvalidInput


def test_it_is_told_and_no_factor_that_leaves_more_than_rest_does(tmp_path, monkeypatch):
    recording, model = as_recorded(recorded_axis(tmp_path, ())), declared_axis()
    light = replace(model, device=replace(model.device, inertia=model.device.inertia / 1000.0))
    bench = bench_of(recording, light, groups_of(recording))
    values = {p.name: p.value for p in bench.predictor.parameters}
    parts = scaled(bench.parts, bench.predictor, values)
    monkeypatch.setattr(hopeless, "_eased", lambda *_: False)
    with pytest.raises(InvalidInput) as told:
        refuse_hopeless(bench, recording, values, values, parts)
    assert "the model's numbers: device.inertia 1,000 times as declared" in str(told.value)
    assert "of factors on what is measured" not in str(told.value)
