"""Two forms of one effect are told apart by what they bent to, while another was missing."""

import numpy as np
import pytest
from toy_rig import ALONG_X, ALONG_Y, ToyRig, tracer

from simpter_hybrid.identification.fitting.fitted_model import Split, refitted
from simpter_hybrid.identification.fitting.predictor import Candidate, Parameter
from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.tracing.rounds import search_effects

#: Another form of what goes along x: with a little of y, as the whole lack has it.
LEANT = Candidate(
    "along x, leant", (Parameter("lean", 0.0, -5.0, 5.0, 0.05),), ((0.1,),), "x", "friction",
    ("friction:x",),
)  # fmt: skip
#: What goes along x and z, each as it likes: needless beside y.
WIDE = Candidate(
    "wide", (*ALONG_X.parameters, *LEANT.parameters), ((0.1, 0.1),), "wide", "friction",
    ("friction:x",), contains=("along x",),
)  # fmt: skip


def run(seed):
    """A lack along x and y; z follows x, a part of y, and something else besides."""
    time = np.arange(2000) * 0.01
    x, y = np.sin(2.3 * time + seed), np.cos(5.1 * time + 2 * seed)
    other = 0.1 * np.cos(11.0 * time)
    inputs = {"u": 1.0 + 0.5 * np.sin(time), "x": x, "y": y, "z": x + 0.1 * y + other}
    noise = 0.1 * np.random.default_rng(seed).standard_normal(2000)
    seen = Observation(inputs["u"] + x + 0.25 * y + noise, 0.1, np.ones(2000, bool))
    return Replay(f"run {seed}", "abc"[seed % 3], time, inputs, {"torque": seen})


def searched(*candidates):
    split = Split([run(1), run(2)], [run(4), run(5)], [run(7)])
    return search_effects(refitted(ToyRig(), split), candidates, split, tracer, floor=1.0)


@pytest.mark.parametrize("other", [LEANT, WIDE])
def test_what_is_better_or_simpler_beside_the_second_effect_is_named(other):
    found = searched(other, ALONG_X, ALONG_Y)
    first = min(found.rounds[0].trials, key=lambda t: t.select_error)
    assert first.candidate is other
    assert sorted(e.name for e in found.corrected.effects) == ["along x", "along y"]
    assert found.corrected.select_error == pytest.approx(1.0, abs=0.05)
    assert found.verdict.kind == "effect"
