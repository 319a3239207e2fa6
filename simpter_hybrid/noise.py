"""Random numbers that depend on a seed, a channel and a counter, and on nothing else.

The same text serves both engines: whole numbers that stay within 63 bits.  Whatever runs
beside it, the same seed gives the same bytes.
"""

from __future__ import annotations

import math


def mixed(x):
    """A hash of a whole number: rounds of a quadratic map and its upper half, modulo 2^31 - 1.

    Parameters
    ----------
    x : int

    Returns
    -------
    int
        From 0 to 2^31 - 2.
    """
    x = x % 2147483647
    for _ in range(3):
        x = (x * 48271 + x // 32768 * 16807 + 12345) % 2147483647
        x = (x * x + 69621 * x + x // 4096) % 2147483647
    return x


def gaussian(seed, channel, k):
    """Standard normal number ``k`` of a channel (Box and Muller).

    Parameters
    ----------
    seed, channel, k : int
        Also as floats: of parts, all numbers are.
    """
    x = mixed(int(seed) * 2654435 + 40503)
    x = mixed(x + int(channel) * 7368787 + 1)
    x = mixed(x + int(k) * 2 + 1)
    u = (x + 0.5) / 2147483647.0
    v = (mixed(x + 1540483477) + 0.5) / 2147483647.0
    return math.sqrt(-2.0 * math.log(u)) * math.cos(2.0 * math.pi * v)


def quantised(value, step):
    """``value`` rounded to the nearest multiple of ``step``; as it is for a step of 0.

    Parameters
    ----------
    value, step : float
        In the same unit.
    """
    if step <= 0.0:
        return value
    return step * math.floor(value / step + 0.5)
