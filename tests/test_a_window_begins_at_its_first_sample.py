"""The motion set from the record is what its sample is compared with, not the window before."""

import numpy as np
import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.effects.viscous_drag import ViscousDrag
from simpter_hybrid.identification.benches import as_recorded, bench_of
from simpter_hybrid.identification.recordings.groups import groups_of


@pytest.mark.parametrize("rate_noise", [None, 0.01])
def test_a_window_begins_at_its_first_sample(tmp_path, rate_noise):
    declared = declared_axis()
    recording = as_recorded(recorded_axis(tmp_path, [ViscousDrag(coordinate=0, coefficient=0.1)],
                                          rate_noise))  # fmt: skip
    bench = bench_of(recording, declared, groups_of(recording))
    (replay,) = bench.parts["fit"]
    values = {p.name: p.value for p in bench.predictor.parameters}
    predicted = bench.predictor.predict(values, [replay])["position"][0]
    for restart in replay.restarts:
        # The model lacks half of the drag: the window before has drifted by far more than the way
        # of a nanosecond.
        assert predicted[restart.index] == pytest.approx(restart.position, abs=1e-7)
    drifted = [abs(predicted[r.index - 1] - replay.notes["position"][r.index - 1])
               for r in replay.restarts]  # fmt: skip
    assert np.median(drifted) > 1e-3
