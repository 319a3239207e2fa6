"""One way only: asked of the friction of a rotor, and of the one balance of an axis."""

from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.identification.tracing.trace import Trace
from simpter_hybrid.identification.tracing.traced import one_way


def found(balance, directions):
    nothing = np.zeros(len(directions))
    trace = Trace(nothing, nothing, {"direction": np.array(directions, float)})
    return SimpleNamespace(fit={balance: [trace]})


@pytest.mark.parametrize("balance", ["friction", "force"])
def test_a_motion_to_one_side_with_rests_is_one_way(balance):
    assert one_way(found(balance, [1.0] * 60 + [0.0] * 40))
    assert not one_way(found(balance, [1.0] * 60 + [-1.0] * 40))


def test_where_no_direction_is_known_nothing_is_said():
    assert not one_way(found("joint_1", [1.0] * 60))
