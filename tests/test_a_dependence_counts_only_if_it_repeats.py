"""Curves are learned on one battery and tested on another against surrogates."""

import numpy as np
from scipy.signal import lfilter

from simpter_hybrid.identification.tracing.locating import located
from simpter_hybrid.identification.tracing.signature import dependences, surrogate
from simpter_hybrid.identification.tracing.trace import Trace


def _trace(seed, gain, colour=0.0, samples=3000):
    generator = np.random.default_rng(seed)
    time = np.arange(samples) * 0.01
    x = np.sin(0.9 * time + generator.uniform(0, 6))
    y = np.cos(2.1 * time + generator.uniform(0, 6))
    noise = lfilter([np.sqrt(1 - colour**2)], [1.0, -colour], generator.standard_normal(samples))
    return Trace(noise + gain * x, np.ones(samples), {"x": x, "y": y})


def test_a_real_one_is_located_first():
    found = dependences([_trace(1, 0.5), _trace(2, 0.5)], [_trace(3, 0.5)])
    assert located(found) == ("x",)
    # Share of the variance that 0.5 sin has over unit noise: 0.125 / 1.125.
    assert abs(found[0].gain - 0.111) < 0.03  # two standard errors of 3000 samples, noise 1


def test_a_run_that_is_too_short_to_tell_changes_nothing():
    short = _trace(4, 0.5).thinned(5000)
    assert short.residual.size == 0
    learned, tested = [_trace(1, 0.5), _trace(2, 0.5)], [_trace(3, 0.5)]
    of_all = dependences([*learned, short], [short, *tested])
    alone = dependences(learned, tested)
    assert [(d.gain, d.p_value) for d in of_all] == [(d.gain, d.p_value) for d in alone]
    assert dependences(learned, [short]) == []


def test_one_that_does_not_repeat_is_not():
    assert located(dependences([_trace(1, 0.5)], [_trace(3, 0.0)])) == ()
    assert located(dependences([_trace(1, 0.5)], [_trace(3, -0.5)])) == ()


def test_coloured_noise_makes_none():
    # 40 tests of 2 coordinates at p <= 0.01 would let 0.8 pass if p-values alone decided; a gain
    # of 2 % must be there as well.
    false = 0
    for seed in range(40):
        learned, tested = [_trace(2 * seed, 0.0, 0.95)], [_trace(2 * seed + 1, 0.0, 0.95)]
        false += bool(located(dependences(learned, tested, seed)))
    assert false <= 3


def test_a_surrogate_keeps_the_spectrum():
    values = np.random.default_rng(1).standard_normal(257)
    twins = surrogate(values, 3, np.random.default_rng(2))
    spectrum = np.abs(np.fft.rfft(values))
    assert np.allclose(np.abs(np.fft.rfft(twins, axis=1)), spectrum, atol=1e-9)  # rounding
    assert not np.allclose(twins[0], twins[1])
