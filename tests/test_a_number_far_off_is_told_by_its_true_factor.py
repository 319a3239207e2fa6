"""Between the factors that are tried a fit sticks where a model nearly rests; nearer ones lead."""

from dataclasses import replace

import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.identification.benches import as_recorded, bench_of
from simpter_hybrid.identification.deviations import scaled
from simpter_hybrid.identification.numbers_instead import numbers_instead
from simpter_hybrid.identification.recordings.groups import groups_of


@pytest.mark.parametrize("factor", [0.03, 7.0, 200.0, 500.0])
def test_whatever_that_is(tmp_path, factor):
    recording, model = as_recorded(recorded_axis(tmp_path, ())), declared_axis()
    off = replace(model, device=replace(model.device, inertia=model.device.inertia / factor))
    predictor = (bench := bench_of(recording, off, groups_of(recording))).predictor
    values = {p.name: p.value for p in predictor.parameters}
    parts = scaled(bench.parts, predictor, values)
    (number,) = numbers_instead(predictor, values, parts["fit"], parts["select"], 0.1)
    assert number.times == pytest.approx(factor, rel=0.05)  # the friction moves along with it
