"""What stays for seconds is a state; what follows the motion, or is noise, is none."""

import numpy as np
import pytest
from scipy.signal import lfilter

from simpter_hybrid.identification.tracing.locating import RUN, located
from simpter_hybrid.identification.tracing.slow_state import slow_state
from simpter_hybrid.identification.tracing.trace import Trace
from simpter_hybrid.identification.tracing.traced import of_all_balances

RUNS, SAMPLES = 8, 1200  # blocks of 10 ms


def _where(lack, noise=lambda white: white):
    generator = np.random.default_rng(3)
    traces = []
    for _ in range(RUNS):
        time = 0.01 * np.arange(SAMPLES)
        torque = np.sign(np.sin(2 * np.pi * 0.7 * time)) * (1.0 + 0.3 * np.sin(9.0 * time))
        residual = lack(time, torque, generator) + noise(0.2 * generator.standard_normal(SAMPLES))
        traces.append(Trace(residual, torque, {"time": time}))
    found = slow_state(traces)
    return located(of_all_balances({"friction": (found,)}), RUN)


def _of_runs(time, torque, generator):
    return 0.3 * generator.standard_normal() * torque


def _wandering(time, torque, generator):
    return 0.3 * torque * np.sin(1.1 * time + generator.uniform(0.0, 2 * np.pi))


@pytest.mark.parametrize("lack", [_of_runs, _wandering])
def test_a_state_of_each_run_is_found(lack):
    assert _where(lack) == ("friction:run",)


def _nothing(time, torque, generator):
    return 0.0 * time


def _of_motion(time, torque, generator):
    return 0.3 * np.sin(2 * np.pi * 0.7 * time)


def _coloured(white):
    return lfilter([1.0], [1.0, -np.exp(-0.5)], white)  # correlated over 20 ms


@pytest.mark.parametrize("noise", [lambda white: white, _coloured])
@pytest.mark.parametrize("lack", [_nothing, _of_motion])
def test_noise_and_what_follows_the_motion_are_none(lack, noise):
    assert _where(lack, noise) == ()


def test_too_few_seconds_tell_nothing():
    assert slow_state([Trace(np.ones(500), np.ones(500), {})]) is None
