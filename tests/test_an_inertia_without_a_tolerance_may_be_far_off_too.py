"""Who gives friction a tolerance and the inertia none has not said that the inertia is exact."""

from dataclasses import replace
from types import SimpleNamespace as Some

import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.identification.benches import as_recorded, bench_of
from simpter_hybrid.identification.far_off import by_its_inverse, far_off
from simpter_hybrid.identification.fitting.fitted_model import Split, refitted
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.reporting.cautions import far_off_sentence

#: So far off most of a residual counts as much whatever the inertia is.
TIMES = 10.0


def asked(folder, tolerances=()):
    """What is asked where the inertia is declared ten times too large."""
    recording = as_recorded(recorded_axis(folder, ()))
    model = declared_axis()
    told = [*model.notes["tolerances"], *tolerances]
    model = replace(model, notes={**model.notes, "tolerances": told})
    model = replace(model, device=replace(model.device, inertia=TIMES * model.device.inertia))
    bench = bench_of(recording, model, groups_of(recording))
    split = Split(*(bench.parts[part] for part in ("fit", "select", "report")))
    at_first = refitted(bench.predictor, split)
    return far_off(
        Some(refitted=at_first, corrected=at_first, verdict=Some(kind="unknown")), split, 1.0
    )


@pytest.fixture(scope="module")
def off(tmp_path_factory):
    return asked(tmp_path_factory.mktemp("axis"))


def test_it_is_told_with_how_far_off_it_is(off):
    assert (off.name, off.known) == ("device.inertia", False)
    # Takes on an encoder know an inertia to a thousandth; a hundredth is far more.
    assert off.times == pytest.approx(1.0 / TIMES, rel=0.01)


def test_no_tolerance_is_spoken_of_that_nobody_gave(off):
    said = far_off_sentence(off)
    assert said.startswith("Is a declared number far off? With device.inertia 0.1 times")


def test_its_inverse_is_known_where_nothing_drives(off):
    told = by_its_inverse(off, declared_axis())
    assert told == "all its forces 10 times as declared"


def test_so_it_is_found_with_a_tolerance(tmp_path):
    known = {"name": "inertia", "parameters": ["device.inertia"], "relative": 0.1}
    found = asked(tmp_path, [known])
    assert (found.name, found.known) == ("inertia", True)
    assert found.times == pytest.approx(1.0 / TIMES, rel=0.01)  # as above
