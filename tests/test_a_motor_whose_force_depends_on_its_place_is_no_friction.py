"""Ripple in proportion to what drives, and bearings that rub by what hangs on them, by name.

Recorded by a simulator of this file's own: small steps, and stiction as a limit of what one stops.
"""

import numpy as np
import pytest
from axis_recordings import MAP, NEWTON_METRES, SPEED, declared_axis, written

from simpter_hybrid.identification.axis.candidates import axis_candidates
from simpter_hybrid.identification.axis.sizes import AxisSizes, pulls_back
from simpter_hybrid.identification.diagnosis import diagnose

INERTIA, WEIGHT, COULOMB, VISCOUS, STEP, ROW = 0.02, 0.5, 0.2, 0.02, 2e-4, 0.004


def take(k, seconds, ripple, rise):
    """Position, speed and torque, row by row, of an axis that swings by what drives it."""
    t = STEP * np.arange(round(seconds / STEP))
    told = 0.9 * np.sin((2.0 + 0.5 * k) * t) + 0.4 * np.sin(5.3 * t + k)
    q, v, seen = 0.0, 0.0, []
    for i, u in enumerate(told.tolist()):
        if i % round(ROW / STEP) == 0:
            seen.append((q, v, u))
        falls = WEIGHT * np.sin(q)
        force = u * (1.0 + ripple * np.cos(6.0 * q)) - falls - VISCOUS * v
        rubs = COULOMB + rise * abs(falls)
        free = v + force * STEP / INERTIA
        v = np.sign(free) * max(abs(free) - rubs * STEP / INERTIA, 0.0)
        q += v * STEP
    return np.array(seen).T


def recorded(folder, ripple=0.0, rise=0.0):
    generator = np.random.default_rng(4)
    rows = ["take,ms,angle,torque,rate"]
    for k in range(3):
        q, v, u = take(k, 6.0, ripple, rise)
        q, v = q + generator.normal(0.0, 2e-4, q.size), v + generator.normal(0.0, 0.01, q.size)
        rows += [
            f"{k},{1e3 * ROW * i:.1f},{-np.degrees(a):.5f},{b / NEWTON_METRES:.6f},{-c:.6f}"
            for i, (a, b, c) in enumerate(zip(q, u, v, strict=True))
        ]
    return written(folder, rows, MAP + SPEED)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("lack", "name", "number", "size"),
    [
        ({"ripple": 0.12}, "drive-ripple", "drive-ripple.cosine", 0.12),
        ({"rise": 0.25}, "weight-dependent", "weight-dependent.rise", 0.25),
    ],
)
def test_it_is_named_with_its_size(tmp_path, lack, name, number, size):
    done = diagnose(recorded(tmp_path, **lack), declared_axis()).search
    assert (done.verdict.kind, [e.name for e in done.corrected.effects]) == ("effect", [name])
    # Its steps are of 0.2 ms, and rows of 4 ms tell a drive that bends between them.
    assert done.corrected.values[number] == pytest.approx(size, rel=0.05)


def test_a_weight_is_asked_for_where_the_model_has_one(tmp_path):
    sizes = AxisSizes(1.0, 1.0, 1.0, 4.0, 0.1, True)
    assert pulls_back(declared_axis())
    for pulled in (True, False):
        names = [c.name for c in axis_candidates(sizes, pulled=pulled)]
        assert ("weight-dependent" in names) == pulled
