"""Of what nothing drives the acceleration is a function of the speed: it is no rival of that."""

from types import SimpleNamespace as Some

import numpy as np
import pytest
from coasting_rotor import MAP, POSITION, declared, logged

from simpter_hybrid.identification.benches import as_recorded, bench_of
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.tracing.trace import Trace
from simpter_hybrid.identification.tracing.traced import Traced, mistakable


def traces(drive, missing):
    """Two coast-downs from other speeds; a drag of the square of the speed takes `missing` away."""
    found = []
    for start in (3.0, 2.0):
        speed = np.linspace(start, 0.2, 400)
        along = {
            "slip_velocity": speed,
            "direction": np.ones(400),
            "acceleration": -1.0 - speed**2,
        }
        found.append(Trace(missing * speed**2, drive + 0.0 * speed, along))
    return {"force": found}


@pytest.mark.parametrize(("drive", "asked"), [(0.0, False), (1.0, True)])
def test_it_is_a_rival_only_of_what_is_driven(drive, asked):
    before, after = (
        Traced(runs, runs, {"force": ()})
        for runs in (traces(drive, missing) for missing in (-1.0, 0.0))
    )
    drag = Some(coordinates=("force:slip_velocity",))
    assert ("force:acceleration" in mistakable(drag, before, after)) is asked


def test_an_effect_on_an_acceleration_that_nobody_knows_is_no_matter_of_runs():
    """An elastic part of a wheel whose place is not logged: its coordinate has no values."""
    before, after = traces(0.0, -1.0), traces(0.0, 0.0)
    for one in (*before["force"], *after["force"]):
        one.coordinates.pop("acceleration")
    before, after = (Traced(runs, runs, {"force": ()}) for runs in (before, after))
    part = Some(coordinates=("force:acceleration",))
    assert mistakable(part, before, after)["force:run"] == 0.0


@pytest.mark.parametrize(("more", "asked"), [("", False), (POSITION, True)])
def test_it_is_no_coordinate_of_one_whose_place_nobody_knows(tmp_path, more, asked):
    recording = as_recorded(logged(tmp_path, MAP + more))
    bench = bench_of(recording, declared(), groups_of(recording))
    values = {p.name: p.value for p in bench.predictor.parameters}
    for part in bench.parts.values():
        for trace in bench.tracer(part)(bench.predictor, values, part)["force"]:
            assert ("acceleration" in trace.coordinates) is asked
            assert "slip_velocity" in trace.coordinates
