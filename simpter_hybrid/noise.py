"""Random numbers that depend on a seed, a channel and a counter, and on nothing else.

The same text serves both engines: 32-bit arithmetic that stays within 63 bits.  Whatever runs
beside it, the same seed gives the same bytes.
"""

from __future__ import annotations

import math


def mixed(x):
    """A 32-bit hash of a 32-bit number (constants of the hash-prospector project)."""
    x = x & 0xFFFFFFFF
    x = x ^ (x >> 16)
    x = (x * 0x21F0AAAD) & 0xFFFFFFFF
    x = x ^ (x >> 15)
    x = (x * 0x735A2D97) & 0xFFFFFFFF
    return x ^ (x >> 15)


def gaussian(seed, channel, k):
    """Standard normal number ``k`` of a channel (Box and Muller)."""
    x = mixed(int(seed) * 2654435 + 40503)
    x = mixed(x ^ (int(channel) * 7368787 + 1))
    x = mixed(x + int(k) * 2 + 1)
    u = (x + 0.5) / 4294967296.0
    v = (mixed(x ^ 0x5BD1E995) + 0.5) / 4294967296.0
    return math.sqrt(-2.0 * math.log(u)) * math.cos(2.0 * math.pi * v)


def quantised(value, step):
    """``value`` rounded to the nearest multiple of ``step``; as it is for a step of 0."""
    if step <= 0.0:
        return value
    return step * math.floor(value / step + 0.5)
