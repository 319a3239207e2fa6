"""A tester's `torque` is compared as a force; its noise and its unit stay those of its sensor."""

from types import SimpleNamespace

import numpy as np
import pytest
from axis_recordings import MAP, written

from simpter_hybrid.identification.axis.prescribed_replays import prescribed_replays
from simpter_hybrid.identification.benches import as_recorded
from simpter_hybrid.identification.reporting.held_out_data import noise_of_channels

NOISE = 0.03


def test_however_far_off_the_declared_model_is(tmp_path):
    turned = MAP.replace('role = "measured"', 'role = "input"', 1)
    turned = turned.replace(
        'unit = "lbf*in"\nsign = 1\nrole = "input"', 'unit = "mN*m"\nsign = 1\nrole = "measured"'
    )
    generator, time = np.random.default_rng(3), 0.004 * np.arange(500)
    rows = [
        f"{take},{1e3 * t:.0f},{20 * np.sin((3 + take) * t):.5f},"
        f"{np.cos((3 + take) * t) + NOISE * generator.standard_normal():.5f}"
        for take in range(3)
        for t in time
    ]
    taken = as_recorded(written(tmp_path, ["take,ms,angle,torque", *rows], turned))
    assert taken.channels["force"].unit == "mN*m"
    (replay, *_) = prescribed_replays(taken, inertia=0.01)
    # As large as what a model far off leaves.
    for seen in replay.observed.values():
        object.__setattr__(seen, "sd", 20.0 * seen.sd)
    found = noise_of_channels(SimpleNamespace(replays=[replay]), taken)
    # 1500 samples tell a deviation to 2 %; three of that, and the motion's slow part.
    assert found["force"] == pytest.approx(1e-3 * NOISE, rel=0.1)
