"""A noise of 0.1 deg is told of a sensor whose rows differ by a hundredth of that."""

import numpy as np
import pytest
from axis_recordings import MAP, written

ASKED = "differs from row to row by far less than the `noise`"


@pytest.mark.parametrize(("told", "remarked"), [("0.1 deg", True), ("0.003 deg", False)])
def test_it_is_asked_whether_it_is_slow_or_too_large(tmp_path, told, remarked):
    draw, rows = np.random.default_rng(2), ["take,ms,angle,torque"]
    for take in range(3):
        for k in range(200):
            angle = 10.0 * np.sin(0.05 * k) + 0.001 * draw.standard_normal()
            rows.append(f"{take},{4 * k},{angle:.5f},{np.sin(0.05 * k):.4f}")
    noisy = MAP.replace('column = "angle"', f'column = "angle"\nnoise = "{told}"')
    findings = [f for f in written(tmp_path, rows, noisy).findings if ASKED in f.what]
    assert bool(findings) == remarked
    assert all("deg" in f.value and told in f.right for f in findings)
