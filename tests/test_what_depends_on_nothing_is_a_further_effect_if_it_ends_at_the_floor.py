"""A second lack that no coordinate shows is named where it takes all that is left."""

import numpy as np
import pytest
from toy_rig import ALONG_X, ALONG_Y, ToyRig, toy_replay, tracer

from simpter_hybrid.identification.fitting.fitted_model import Split, refitted
from simpter_hybrid.identification.tracing.rounds import search_effects


def _blind(predictor, values, replays):
    """Residuals are looked at along x alone."""
    seen = tracer(predictor, values, replays)
    for trace in seen["friction"]:
        del trace.coordinates["y"], trace.coordinates["u"]
    return seen


def _found(along_y, between):
    """`between` acts where no candidate does: faster than any of them."""

    def run(seed, experiment):
        replay = toy_replay("run", seed, gain=0.3, experiment=experiment)
        more = along_y * replay.inputs["y"] + between * np.sin(9.7 * replay.time + seed)
        replay.observed["torque"].values[:] += more
        return replay

    split = Split([run(1, "a"), run(2, "b")], [run(4, "c"), run(5, "d")], [])
    declared = refitted(ToyRig(), split)
    return search_effects(declared, [ALONG_X, ALONG_Y], split, _blind, floor=1.0)


# Noise is 0.1: 0.07 along y leaves sqrt(1 + 0.49 / 2) = 1.12 times the floor without it; 0.06
# between leaves 1.09 with it, and 1.19 without.
@pytest.mark.parametrize(
    ("along_y", "between", "named"),
    [(0.07, 0.0, ["along x", "along y"]), (0.07, 0.06, ["along x"]), (0.0, 0.06, ["along x"])],
)
def test_only_what_ends_at_the_floor_is_believed(along_y, between, named):
    found = _found(along_y, between)
    assert [e.name for e in found.corrected.effects] == named
    assert found.verdict.kind == ("effect" if len(named) == 2 else "form incomplete")
