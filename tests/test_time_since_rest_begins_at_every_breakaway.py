import numpy as np

from simpter_hybrid.identification.tracing.coordinates import since_rest


def test_time_since_rest_begins_at_every_breakaway():
    time = 0.1 * np.arange(8)
    speed = np.array([0.0, 0.0, 0.3, 0.5, 0.0, 0.0, -0.1, -0.2])
    found = since_rest(time, speed)
    np.testing.assert_allclose(found, [0.0, 0.0, 0.1, 0.2, 0.0, 0.0, 0.1, 0.2], atol=1e-12)
