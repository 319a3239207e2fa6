"""The picture of what was added to an axis: the term, not what came of it in a window."""

import numpy as np
import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.effects.stribeck import Stribeck
from simpter_hybrid.identification.benches import bench_of
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.plots.added import difference

HIDDEN = Stribeck(clutch=0, rise=0.3, fade=0.4)


def test_friction_that_falls_with_speed_is_drawn_as_it_falls(tmp_path):
    recording = recorded_axis(tmp_path, (HIDDEN,), rate_noise=0.01)
    bench = bench_of(recording, declared_axis(), groups_of(recording))
    replays = bench.parts["report"]
    candidate = next(c for c in bench.candidates if c.name == "stribeck")
    with_it = bench.predictor.extended(candidate)
    values = {p.name: p.value for p in with_it.parameters}
    values |= {"stribeck.rise": HIDDEN.rise, "stribeck.fade": HIDDEN.fade}
    forces = bench.tracer(replays).forces
    pair = (forces(p, values, replays) for p in (bench.predictor, with_it))
    term = difference(candidate, ("force", "slip_velocity"), *pair)
    moves = np.abs(term.place) > 0.05  # slower, noise of 0.01 rad/s may have turned its direction
    slip = term.place[moves]
    law = -0.2 * HIDDEN.rise * np.sign(slip) * np.exp(-(np.abs(slip / HIDDEN.fade) ** HIDDEN.shape))
    # Coordinates tell a smoothed speed; the friction is of the recorded one, with its noise.
    assert np.median(np.abs(term.value[moves] - law)) < 0.03 * 0.2 * HIDDEN.rise
    assert np.ptp(law) == pytest.approx(0.12, rel=0.15)
