"""A gap crossed after every reversal fills a hundredth of the samples and is found nonetheless."""

import numpy as np

from simpter_hybrid.identification.tracing.coordinates import since_turn
from simpter_hybrid.identification.tracing.locating import located
from simpter_hybrid.identification.tracing.signature import dependences
from simpter_hybrid.identification.tracing.trace import Trace

NAME = "displacement_since_reversal"
GAP, RESOLVED = 4e-3, 1e-3
STEP = 0.01


def _trace(seed, gap, samples=4000):
    """A slow way to and fro at a steady torque that is absent in the gap; white noise."""
    generator = np.random.default_rng(seed)
    time = STEP * np.arange(samples)
    phase = 2 * np.pi * time / generator.uniform(9.0, 11.0)
    position = 0.5 * np.cos(phase)
    since = since_turn(position, RESOLVED)
    torque = -5.0 * np.sign(np.sin(phase))
    missing = np.where(since < gap, -torque, 0.0)
    residual = generator.standard_normal(samples) + missing
    along = {NAME: since, "position": position, "time": time}
    return Trace(residual, torque, along, begins={NAME: RESOLVED})


def _found(seed, gap):
    return dependences([_trace(seed, gap), _trace(seed + 1, gap)], [_trace(seed + 2, gap)], seed)


def test_a_gap_is_located_at_the_displacement_since_reversal_alone():
    found = _found(1, GAP)
    assert located(found) == (NAME,)
    # The missing torque's part of the square: 25 times the part of the samples in the gap.
    crossed = np.mean(_trace(3, GAP).coordinates[NAME] < GAP)
    assert found[0].gain > 0.4 * 25 * crossed / (1 + 25 * crossed)


def test_fine_bins_make_no_dependence_of_noise():
    # p <= 0.01 in 60 sets: 0.6 expected by chance; four have a probability of 0.003.
    few = [d.p_value <= 0.01 for k in range(60) for d in _found(3 * k, 0.0) if d.coordinate == NAME]
    assert len(few) == 60
    assert sum(few) <= 3
    assert not any(located(_found(3 * k, 0.0)) for k in range(20))


def test_a_way_since_a_turn_starts_at_the_turn_and_not_where_it_was_noticed():
    position = np.concatenate([np.linspace(0, 1, 101), np.full(50, 1.0), np.linspace(1, 0, 101)])
    since = since_turn(position, 0.05)
    assert np.allclose(since[:151], position[:151])  # the rest belongs to the way before it
    assert np.allclose(since[151:], 1.0 - position[151:])
    assert since[152] < 0.03  # of 0.05 that are needed to be sure


def test_noise_does_not_turn_a_motion():
    noise = 1e-4 * np.random.default_rng(1).standard_normal(2000)
    position = np.concatenate([np.linspace(0, 1, 1000), np.full(1000, 1.0)]) + noise
    assert np.allclose(since_turn(position, 1e-3), position, atol=1e-3)
