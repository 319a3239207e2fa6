"""``1/s`` and ``1/(rad/s)`` are units wherever a sweep takes a unit behind its last number."""

import pytest

from simpter_hybrid.problems import Problems
from simpter_hybrid.sweeps.axis import read_axis


@pytest.mark.parametrize(
    "given",
    ["0.1..0.3 1/(rad/s)", "0.1:0.3 1/(rad/s):2", "0.1:0.3:2 1/(rad/s)", "0.1,0.3 1/(rad/s)"],
)
def test_a_unit_of_a_sweep_may_begin_with_one_over(given):
    axis = read_axis(f"clutch.torque.slope={given}", Problems("--vary"))
    ends = (axis.at(0.0), axis.at(1.0)) if axis.ends else axis.values
    assert ends == ("0.1 1/(rad/s)", "0.3 1/(rad/s)")
