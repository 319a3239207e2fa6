"""A mass on a spring, let go, with dry friction: 36 rows a swing, and nothing missing.

A polynomial through nearly half a swing cuts its top, and where the trace of force was set anew
from it the spring seemed wrong in proportion to the place.
"""

import numpy as np
from sprung_mass import MODEL, SPRING, recorded

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.benches import bench_of
from simpter_hybrid.identification.recordings.groups import groups_of


def test_no_force_goes_along_with_the_place(tmp_path):
    recording = recorded(tmp_path)
    bench = bench_of(recording, parse(MODEL), groups_of(recording))
    replays = bench.parts["fit"]
    true = {p.name: p.value for p in bench.predictor.parameters}
    (traces,) = bench.tracer(replays)(bench.predictor, true, replays).values()
    place = np.concatenate([trace.coordinates["position"] for trace in traces])
    force = np.concatenate([trace.residual for trace in traces])
    # A hundredth of the spring's before; noise of 2 mm, over half a second, leaves a thousandth.
    assert abs(np.polyfit(place, force, 1)[0]) < 0.002 * SPRING
