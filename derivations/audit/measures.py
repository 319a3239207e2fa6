"""Equations (44)-(48): performance measures, and the direction of the desired velocity."""

from __future__ import annotations

import math
from itertools import pairwise

from derivations.audit.compare import random_points
from derivations.audit.verdict import Entry

POINTS = list(random_points(40, 2, 2, 3.0))
TIMES = [0.02 * k + 0.003 * (k % 3) for k in range(40)]


def _path_weight(k: int, first_root: bool) -> float:
    """Weight of sample k in (44)."""
    (x1, y1), (x2, y2), (x3, y3) = POINTS[k - 1 : k + 2]
    ahead = (x3 - x2) ** 2 + (y3 - y2) ** 2
    behind = math.hypot(x2 - x1, y2 - y1)
    return ((math.sqrt(ahead) if first_root else ahead) + behind) / 2.0


def _path_weights_add_up(first_root: bool) -> bool:
    """Interior weights and half of the end pieces make up the path length."""
    lengths = [math.dist(a, b) for a, b in pairwise(POINTS)]
    total = sum(_path_weight(k, first_root) for k in range(1, len(POINTS) - 1))
    return math.isclose(total + (lengths[0] + lengths[-1]) / 2.0, sum(lengths), rel_tol=1e-12)


def _time_weights_add_up(tilde: bool) -> bool:
    """(45), (46) as a weighting; without the tilde both sides name the same value."""
    weights = [(TIMES[k + 1] - TIMES[k - 1]) / 2.0 for k in range(1, len(TIMES) - 1)]
    if not tilde:
        return all(math.isclose(weight, 1.0) for weight in weights)
    ends = (TIMES[1] - TIMES[0] + TIMES[-1] - TIMES[-2]) / 2.0
    return math.isclose(sum(weights) + ends, TIMES[-1] - TIMES[0], rel_tol=1e-12)


def desired_angle(distance: float, gain: float, threshold: float) -> float:
    """(47), (48) [rad] with (48) in force beyond ``threshold``."""
    if abs(distance) > threshold:
        return math.copysign(math.pi / 4.0, distance)
    return math.asin(distance / gain)


def _capped(threshold: float, gain: float = 1.0) -> bool:
    """The text: 45 degrees is the highest angle allowed."""
    angles = [desired_angle(0.001 * k, gain, threshold * gain) for k in range(-2000, 2001)]
    return max(map(abs, angles)) <= math.pi / 4.0 + 1e-12


def _continuous(threshold: float) -> bool:
    just_inside = desired_angle(threshold, 1.0, threshold)
    just_outside = desired_angle(math.nextafter(threshold, 2.0), 1.0, threshold)
    return abs(just_inside - just_outside) < 1e-12


def _angle_47(largest: float) -> bool:
    """(47) alone keeps the cap for distances up to ``largest`` times K_v."""
    return math.asin(largest) <= math.pi / 4.0 + 1e-12


def entries() -> list[Entry]:
    """Entries of equations (44)-(48)."""
    weights = "weights of a random path add up to its length (ends: half a piece each)"
    times = "weights add up to the duration (ends: half a step each)"
    threshold = math.sqrt(0.5)
    return [
        Entry(
            "44", "path-weighted position error", weights,
            lambda: _path_weights_add_up(first_root=False), "root",
            lambda: _path_weights_add_up(first_root=True),
        ),
        *(
            Entry(number, what, times, lambda: _time_weights_add_up(tilde=False), "tilde",
                  lambda: _time_weights_add_up(tilde=True),
                  remark="in an exact model the jerk has pulses: its average depends on the step"
                  if number == "46" else "")
            for number, what in (("45", "time-weighted acceleration"),
                                 ("46", "time-weighted jerk"))
        ),
        Entry(
            "47", "angle of the desired velocity", "against the text's cap of 45 degrees",
            lambda: _angle_47(1.0),
            condition="|d| <= K_v / sqrt(2), where it reaches 45 degrees; at |d| = K_v it is 90",
            conditional=lambda: _angle_47(threshold),
        ),
        Entry(
            "48", "cap of that angle", "against the text's cap of 45 degrees, and for continuity",
            lambda: _capped(1.0) and _continuous(1.0),
            corrected="if |d| > K_v / sqrt(2), then sign(d) pi/4",
            correction=lambda: _capped(threshold) and _continuous(threshold),
            remark="as printed the angle rises to 90 degrees and then drops to 45; a lost root "
            "would have left its 2 behind",
        ),
    ]  # fmt: skip
