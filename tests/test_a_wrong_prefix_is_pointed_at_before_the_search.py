"""Whoever ends a search that goes astray should have been told why: an inertia in grams."""

from dataclasses import replace

import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.identification.benches import as_recorded, bench_of
from simpter_hybrid.identification.deviations import scaled
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.far_off import first_far_off
from simpter_hybrid.identification.first_refit import first_refit
from simpter_hybrid.identification.recordings.groups import groups_of


def heavy(tmp_path, times):
    """A recording, and its model with so many times the inertia."""
    recording, model = as_recorded(recorded_axis(tmp_path, ())), declared_axis()
    device = replace(model.device, inertia=times * model.device.inertia)
    inertia = {"name": "inertia", "parameters": ["device.inertia"], "relative": 0.1}
    notes = {**model.notes, "tolerances": [*model.notes["tolerances"], inertia]}
    return recording, replace(model, device=device, notes=notes)


def asked(tmp_path, times):
    recording, declared = heavy(tmp_path, times)
    bench = bench_of(recording, declared, groups_of(recording))
    nominal = {p.name: p.value for p in bench.predictor.parameters}
    parts = scaled(bench.parts, bench.predictor, nominal)
    refit = first_refit(bench.predictor, parts["fit"], nominal)
    return first_far_off(bench.predictor, parts, refit.values)


def test_the_number_and_its_factor(tmp_path):
    off = asked(tmp_path, 1e3)
    assert off.name == "inertia"
    # Four steps of a fit, begun at a thousandth: far nearer than the next prefix.
    assert off.times == pytest.approx(1e-3, rel=0.1)


def test_nothing_is_asked_of_a_model_that_fits(tmp_path):
    assert asked(tmp_path, 1.0) is None


def test_a_search_that_is_cut_short_tells_it(tmp_path):
    recording, declared = heavy(tmp_path, 1e3)
    done = diagnose(recording, declared, candidates=(), effort=1e-6)
    assert done.cut_short
    assert done.far_off.name == "inertia"
