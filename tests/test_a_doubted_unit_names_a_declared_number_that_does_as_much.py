"""A mass declared far too small moves the model too far, as another unit of its position would."""

from dataclasses import replace

import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.identification.benches import as_recorded, bench_of
from simpter_hybrid.identification.deviations import scaled
from simpter_hybrid.identification.doubted_channels import Doubt, with_numbers
from simpter_hybrid.identification.first_refit import first_refit
from simpter_hybrid.identification.map_changes import Times
from simpter_hybrid.identification.numbers_instead import NumberInstead
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.reporting.doubted_sentence import doubted_sentence

DOUBT = Doubt(Times(("position",), 100.0), 0.2)


def test_its_factor_is_told_though_it_has_no_tolerance(tmp_path):
    recording, model = as_recorded(recorded_axis(tmp_path, ())), declared_axis()
    light = replace(model, device=replace(model.device, inertia=model.device.inertia / 20.0))
    bench = bench_of(recording, light, groups_of(recording))
    predictor = bench.predictor
    parts = scaled(bench.parts, predictor, {p.name: p.value for p in predictor.parameters})
    refit = first_refit(predictor, parts["fit"], {p.name: p.value for p in predictor.parameters})
    (told,) = with_numbers([DOUBT], predictor, refit.values, parts["fit"], parts)
    (number,) = told.numbers
    assert number.name == "device.inertia"
    # Takes on an encoder know an inertia to a thousandth; the friction moves along with it.
    assert number.times == pytest.approx(20.0, rel=0.05)
    assert number.left < 0.1


def test_what_leaves_less_is_asked_first():
    numbers = (NumberInstead("device.mass", 61.08, 0.04),)
    said = doubted_sentence([DOUBT._replace(numbers=numbers)])
    assert said == (
        "Is a declared number far off, or is a unit in the map wrong? With device.mass 61.1 times "
        "as declared only 4 % of the refitted model's error is left, with position times 100 20 %."
    )
