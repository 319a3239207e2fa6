"""Degrees of freedom of coloured noise are honest: a null is as rarely refused as it says."""

import numpy as np
import pytest
from scipy.signal import lfilter

from simpter_hybrid.identification.fitting.floor import Weighed
from simpter_hybrid.identification.fitting.lack_of_fit import effective_samples, lack_of_fit

SETS = 300


def _noise(generator, colour, samples=1500):
    drawn = generator.standard_normal(samples + 200)
    return lfilter([np.sqrt(1 - colour**2)], [1.0, -colour], drawn)[200:]


def _tests(colour: float, repeated: bool, lack: float = 0.0) -> list:
    generator = np.random.default_rng(3)
    added = lack * np.sin(np.arange(1500) / 40.0)
    found = []
    for _ in range(SETS if not lack else 20):
        left = [_noise(generator, colour) + added for _ in range(3)]
        noise = [_noise(generator, colour) for _ in range(3)] if repeated else []
        found.append(lack_of_fit(*([Weighed("force", x) for x in some] for some in (left, noise))))
    return found


@pytest.mark.parametrize("colour", [0.0, 0.6, 0.95])
@pytest.mark.parametrize("repeated", [True, False], ids=["repeated", "declared"])
def test_p_values_of_coloured_noise_are_spread_evenly(colour, repeated):
    p = np.sort([t.p_value for t in _tests(colour, repeated)])
    assert np.abs(p - (np.arange(SETS) + 0.5) / SETS).max() < 0.1  # Kolmogorov: 0.094 at 1 %


@pytest.mark.parametrize("repeated", [True, False], ids=["repeated", "declared"])
def test_what_is_missing_is_told(repeated):
    assert max(t.p_value for t in _tests(0.6, repeated, lack=0.8)) < 0.01


def test_the_effective_number_of_samples_is_that_of_the_theory():
    colour = 0.8
    series = _noise(np.random.default_rng(1), colour, 100_000)
    expected = series.size * (1 - colour**2) / (1 + colour**2)
    assert effective_samples(series) == pytest.approx(expected, rel=0.05)


def test_white_noise_is_white():
    assert np.mean([t.whiteness for t in _tests(0.0, False)]) == pytest.approx(1.0, abs=0.1)
