"""Runs whose event times can be written down: scenario and expected events.

Every function returns ``(scenario, expected)`` with ``expected`` a list of (kind, t [s], slope of
the guard there [guard unit per s]); instants come from formulas at 40 digits, not from an engine.
"""

from __future__ import annotations

import math

from devices_for_tests import Block, BlockOnBelt, Coulomb, Ramp, RecordedCommands, always_on
from mpmath import atan, exp, findroot, log, mp, mpf, pi, sqrt

from simpter_hybrid.clutch import Clutch
from simpter_hybrid.scenario import Scenario

mp.dps = 40
ON = {"command": (1.0,), "excitation": (1.0,)}


def block_on_belt(**options):
    """Stick-slip of a mass on a spring, on a moving belt; breakaway above slip friction."""
    m, k, slip, brk, v = mpf(1.3), mpf(4.0), mpf(1.0), mpf(1.6), mpf(0.35)
    run = Scenario(
        "belt", BlockOnBelt(1.3, 4.0), (always_on(1.0, 1.6),), (0.0, 0.0), (0.35, 0.35), 12.0,
        **ON, **options,
    )  # fmt: skip
    rate, reach = sqrt(k / m), (brk - slip) / k
    # x - slip/k = reach cos + (v/rate) sin after breakaway; again at the belt's speed after:
    slide = (2 * pi - 2 * atan(reach * rate / v)) / rate
    t, expected = brk / k / v, []
    while t + slide < 12:
        expected += [("breakaway", t, k * v), ("slip stop", t + slide, k * reach / m)]
        t += slide + 2 * reach / v
    return run, expected


def coulomb_oscillator(**options):
    """Vibration against constant friction: the turning points come every half period."""
    m, k, slip, brk = mpf(0.8), mpf(5.0), mpf(0.7), mpf(0.9)
    run = Scenario(
        "oscillator", Block(0.8, 5.0), (always_on(0.7, 0.9),), (2.0,), (0.0,), 12.0, **ON, **options
    )
    half, reach, expected = pi * sqrt(m / k), mpf(2), []
    while k * reach > brk:
        reach -= 2 * slip / k
        expected.append(("slip stop", half * (len(expected) + 1), (k * reach + slip) / m))
    return run, expected


def ramped_block(**options):
    """A force that rises, falls and reverses: breakaway, stop, breakaway the other way."""
    up, down, t1, m, slip, brk = mpf(1.5), mpf(1), mpf(1.2), mpf(2), mpf(1), mpf(1.3)
    corners = ((0.0, 0.0), (1.2, 1.8), (9.0, -6.0))
    run = Scenario(
        "ramp", Block(2.0), (always_on(1.0, 1.3),), (0.0,), (0.0,), 9.0,
        loads=(Ramp(0.0, corners),), **ON, **options,
    )  # fmt: skip
    first, peak = brk / up, up * t1
    speed = (up * (t1**2 - first**2) / 2 - slip * (t1 - first)) / m
    fall = (peak - slip + sqrt((peak - slip) ** 2 + 2 * down * m * speed)) / down
    stop = t1 + fall
    force = peak - down * fall
    again = t1 + (peak + brk) / down
    return run, [
        ("breakaway", first, up),
        ("slip stop", stop, (slip - force) / m),
        ("breakaway", again, down),
    ]


def growing_capacity(**options):
    """Friction that grows behind a lag stops a pushed block; a dropped command lets it go again."""
    lag, m, push, speed, slip, brk, volts = (
        mpf(0.3), mpf(1.5), mpf(2), mpf(1), mpf(0.8), mpf(1.0), mpf(5)
    )  # fmt: skip
    law = Coulomb(0.8, 1.0)
    run = Scenario(
        "capacity", Block(1.5), (Clutch(law, time_constant=0.3, delay=0.0, threshold=0.05),),
        (0.0,), (1.0,), 4.0, loads=(Ramp(0.0, ((0.0, 2.0), (9.0, 2.0))),),
        controllers=((RecordedCommands(1.0), 1),), period=2.0, rec=(5.0, 0.0, 0.0, 0.0),
        command=(5.0,), **options,
    )  # fmt: skip

    def momentum(t):
        return m * speed + push * t - slip * volts * (t - lag * (1 - exp(-t / lag)))

    stop = findroot(momentum, 1.3)
    force = slip * volts * (1 - exp(-stop / lag)) - push
    full = volts * (1 - exp(-2 / lag))
    go = 2 + lag * log(brk * full / push)
    off = 2 + lag * log(full / mpf(0.05))
    return run, [
        ("slip stop", stop, force / m),
        ("breakaway", go, push / lag),
        ("switched", off, mpf(0.05) / lag),
    ]


ALL = (block_on_belt, coulomb_oscillator, ramped_block, growing_capacity)


def event_errors(trajectory, expected) -> list[tuple[float, float]]:
    """(error [s], slope) of every expected event, asserting that no other event happened."""
    found = [e for e in trajectory.events if e.t > 0.0]
    kinds = [e.kind for e in found]
    assert kinds == [kind for kind, _, _ in expected], (kinds, expected)
    pairs = zip(found, expected, strict=True)
    return [(float(abs(mpf(e.t) - t)), float(slope)) for e, (_, t, slope) in pairs]


def largest_error(run, expected, simulate) -> float:
    """Largest error of an event time [s]."""
    trajectory = simulate(run)
    assert trajectory.status == "finished", trajectory.message
    return max((error for error, _ in event_errors(trajectory, expected)), default=math.inf)
