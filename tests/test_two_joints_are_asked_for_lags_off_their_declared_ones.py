"""A clutch that follows its command later than declared: asked where commands tell it."""

from dataclasses import replace

import pytest
from two_joints import declared_joints

from simpter_hybrid.identification.tip.joint_candidates import late_clutches


@pytest.mark.parametrize(
    ("lags", "commanded", "expected"),
    [
        ((0.03, 0.03), (0, 1), {"time-constant": (), "time-constant by clutch": ()}),
        ((0.03, 0.03), (1,), {"time-constant by clutch": ("clutch 2",)}),
        ((0.03, 0.0), (0, 1), {"time-constant by clutch": ("clutch 1",)}),
        ((0.0, 0.0), (0, 1), {}),
        ((0.03, 0.03), (), {}),
    ],
)
def test_of_clutches_that_lag_and_whose_commands_were_recorded(lags, commanded, expected):
    declared = declared_joints()
    clutches = zip(declared.clutches, lags, strict=True)
    late = replace(declared, clutches=tuple(replace(c, time_constant=t) for c, t in clutches))
    found = tuple(late_clutches(late, commanded))
    assert {c.name: c.at for c in found} == expected
    numbers = {number for c in found for _, number in c.shares}
    lagging = {i + 1 for i in commanded if lags[i] > 0.0}
    assert numbers == {f"clutch.{k}.time_constant" for k in lagging}
