"""A line after breakaways stands out in the spectrum; noise and a wrong instant do not."""

import numpy as np
import pytest

from simpter_hybrid.identification.tracing.locating import RINGING, located
from simpter_hybrid.identification.tracing.ringing import line, ringing, ringing_trace
from simpter_hybrid.identification.tracing.trace import Trace
from simpter_hybrid.identification.tracing.traced import of_all_balances

STEP, RUNS = 0.002, 6


def _runs(seed, added):
    generator = np.random.default_rng(seed)
    time = STEP * np.arange(5000)
    traces = []
    for _ in range(RUNS):
        starts = [800, 2000, 3600]
        residual = 0.1 * generator.standard_normal(time.size)
        for start in starts:
            since = time[start:] - time[start]
            residual[start:] += added(since)
        traces.append(ringing_trace(residual, STEP, starts))
    return traces


def _heard(added):
    found = ringing(_runs(1, added), _runs(2, added))
    heard = (found,) if found is not None else ()
    return located(of_all_balances({RINGING: heard}), RINGING), found


@pytest.mark.parametrize("frequency", [28.0, 60.0, 140.0])
def test_a_decaying_tone_is_found_with_its_frequency(frequency):
    where, found = _heard(lambda s: 0.15 * np.exp(-s / 0.15) * np.sin(2 * np.pi * frequency * s))
    assert where == ("ringing:breakaway",)
    assert line(found)[0] == pytest.approx(frequency, abs=4.0)  # a window of 0.25 s tells 4 Hz


@pytest.mark.parametrize(
    "added",
    [
        lambda s: 0.0 * s,
        lambda s: 1.0 * (s < 0.015),
        lambda s: 0.5 * np.exp(-s / 0.1),
        lambda s: 0.3 * ((s > 0.12) & (s < 0.9)),
    ],
    ids=["noise", "a wrong instant", "a slow creeping", "a step in the window"],
)
def test_what_does_not_ring_is_not_heard(added):
    assert _heard(added)[0] == ()


@pytest.mark.parametrize(("slowest", "heard"), [(17.3, False), (8.0, True)])
def test_a_spectrum_that_falls_all_the_way_on_the_tested_runs_has_no_line(slowest, heard):
    def spectrum(*lines):
        after = np.array([*lines, *np.ones(30)])
        told = {"breakaway": 8.0 + 4.0 * np.arange(after.size), "windows": np.full(after.size, 9.0)}
        return Trace(after, np.ones(after.size), told)

    learned, tested = spectrum(14.0, 17.1, 9.0, 6.0), spectrum(slowest, 14.5, 8.7, 6.4)
    assert (ringing([learned], [tested]) is not None) == heard


def test_the_jump_of_a_second_breakaway_is_in_no_window():
    residual = np.random.default_rng(1).standard_normal(5000)
    both = ringing_trace(residual, STEP, [1000, 1080, 3000])
    assert both.coordinates["windows"][0] == 2.0  # after the second and the third


def test_a_residual_without_noise_has_no_line():
    still = ringing_trace(np.full(5000, 0.3), STEP, [800, 2000, 3600])
    found = ringing([still] * 3, [still] * 3)
    assert found is None or not located(of_all_balances({RINGING: (found,)}), RINGING)


def test_a_run_sampled_at_another_rate_is_left_out():
    def tone(since):
        return 0.15 * np.exp(-since / 0.15) * np.sin(2 * np.pi * 60.0 * since)

    noise = np.random.default_rng(3).standard_normal(5000)
    other = ringing_trace(noise, 2 * STEP, [800, 2000, 3600])
    whole = ringing(_runs(1, tone), _runs(2, tone))
    mixed = ringing([other, *_runs(1, tone)], [*_runs(2, tone), other])
    assert line(mixed) == line(whole)


def test_a_clock_that_jitters_silences_nothing():
    def ticking(seed):
        generator = np.random.default_rng(seed)
        residual, starts = 0.1 * generator.standard_normal(5000), [800, 2000, 3600]
        for start in starts:
            since = STEP * np.arange(5000 - start)
            residual[start:] += 0.15 * np.exp(-since / 0.15) * np.sin(2 * np.pi * 60.0 * since)
        return ringing_trace(residual, STEP * (1.0 + 1e-5 * generator.standard_normal()), starts)

    runs = [[ticking(10 * k + i) for i in range(RUNS)] for k in range(2)]
    assert line(ringing(*runs))[0] == pytest.approx(60.0, abs=4.0)


def test_a_run_without_a_whole_window_tells_nothing():
    assert ringing_trace(np.ones(100), STEP, [10]) is None
    assert ringing([], []) is None
