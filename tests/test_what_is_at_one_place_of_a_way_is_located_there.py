"""A detent within a fortieth of the way is lost in bins that are a twelfth of it."""

from dataclasses import replace

import numpy as np
import pytest

from simpter_hybrid.identification.empirical_terms import terms_over
from simpter_hybrid.identification.tracing.curve import stretch
from simpter_hybrid.identification.tracing.signature import dependences
from simpter_hybrid.identification.tracing.trace import PLACE, Trace

PLACE_OF_IT, WIDTH, NOISE = 0.05, 0.008, 0.1


def detent(x):
    far = (x - PLACE_OF_IT) / WIDTH
    return -far * np.exp(0.5 - 0.5 * far**2)


def along_a_way(seed, law, samples=4000):
    """A run over 0.64 m and back again and again; the force that is missing, with noise."""
    generator = np.random.default_rng(seed)
    x = 0.32 * np.sin(0.013 * np.arange(samples) + seed)
    speed = np.gradient(x)
    missing = law(x) + NOISE * generator.standard_normal(samples)
    along = {"position": x, "slip_velocity": speed}
    return Trace(missing, np.ones(samples), along, local=PLACE)


def of_position(learned, tested):
    return next(d for d in dependences([learned], [tested]) if d.coordinate == "position")


def test_finer_bins_show_what_wide_ones_hide():
    learned, tested = along_a_way(1, detent), along_a_way(2, detent)
    wide = of_position(replace(learned, local=()), replace(tested, local=()))
    fine = of_position(learned, tested)
    assert wide.gain < 0.02 < fine.gain  # counts as a dependence from there on, see `locating`
    assert fine.p_value < 0.01
    strongest = np.nanargmax(np.abs(fine.added + fine.scaled))
    assert abs(fine.centres[strongest] - PLACE_OF_IT) < 3 * WIDTH


def test_noise_depends_on_no_place():
    p_values = []
    for seed in range(20):
        pair = (along_a_way(2 * seed + k, lambda x: 0.0 * x) for k in (0, 1))
        p_values.append(of_position(*pair).p_value)
    # Two of twenty below a twentieth: one is expected, four or more come by 1.6 % chance.
    assert sum(p < 0.05 for p in p_values) < 4


def test_a_curve_is_tried_where_it_is_and_not_over_all_of_the_way():
    run = along_a_way(3, detent)
    low, high = stretch([run], "position")
    assert low < PLACE_OF_IT - WIDTH < PLACE_OF_IT + WIDTH < high
    assert high - low < 0.2 * np.ptp(run.coordinates["position"])
    first = terms_over("force:position", {"force": [run]})[0]
    assert (first.effect.low, first.effect.high) == pytest.approx((low, high))


def test_a_wave_along_the_way_is_at_no_place():
    assert stretch([along_a_way(3, lambda x: np.sin(10.0 * x))], "position") is None
