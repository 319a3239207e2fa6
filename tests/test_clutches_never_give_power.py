"""The power of every clutch is at most zero, at every instant, not only on the whole."""

import numpy as np
import pytest
from random_runs import KINDS, random_run

from simpter_hybrid.engine import simulate

C = np.array([[1, 0], [0, 1], [1, -1], [1, 1]])
#: A slip velocity of the wrong sign that the integrator's tolerance explains [rad/s].
ROUNDING = 1e-11


@pytest.mark.parametrize("kind", KINDS)
def test_slip_has_the_sign_of_its_mode(kind):
    """Torque opposes the mode's direction, so power is negative where slip agrees with it."""
    trajectory = simulate(random_run(kind, 2, 2.0))
    for k, (begin, end) in enumerate(trajectory.segment_t):
        slipping = abs(trajectory.mode[k]) == 1
        for t in np.linspace(begin, end, 20):
            if trajectory.segment_at(t) == k:
                slip = C @ trajectory.state(t)[2:4]
                assert (slip * trajectory.mode[k])[slipping].min(initial=0.0) >= -ROUNDING


@pytest.mark.parametrize("kind", KINDS)
def test_dissipated_energy_only_grows(kind):
    trajectory = simulate(random_run(kind, 2, 2.0))
    heat = np.array([*trajectory.step_y[:, -4:], trajectory.end[-4:]])
    assert heat[-1].max() > 0.0
    # A step that begins where slip is zero adds less than the rounding of the sum.
    assert np.diff(heat, axis=0).min() >= -1e-15 * heat.max()
