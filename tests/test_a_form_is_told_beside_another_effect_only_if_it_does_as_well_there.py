"""While a second effect is missing, a form may come near that the whole model excludes."""

from dataclasses import replace

import numpy as np
import pytest
from toy_rig import ALONG_X, ALONG_Y, ToyRig, toy_replay, tracer

from simpter_hybrid.identification.fitting.fitted_model import Split, refitted
from simpter_hybrid.identification.fitting.predictor import Candidate, Parameter
from simpter_hybrid.identification.forms_beside import forms_beside
from simpter_hybrid.identification.tracing.rounds import search_effects

#: Another form of what goes along x.
LEANT = Candidate(
    "along x, leant", (Parameter("lean", 0.0, -5.0, 5.0, 0.05),), ((0.1,),), "x", "friction",
    ("friction:x",),
)  # fmt: skip


def run(seed, apart):
    """A lack along x and y; z is x but for a part as large as noise, or a tenth of that."""
    base = toy_replay(f"run {seed}", seed, gain=1.0, experiment="abc"[seed % 3])
    seen, y = base.observed["torque"], base.inputs["y"]
    z = base.inputs["x"] + apart * np.cos(11.0 * base.time)
    torque = replace(seen, values=seen.values + y)
    return replace(base, inputs={**base.inputs, "z": z}, observed={"torque": torque})


@pytest.mark.parametrize(("apart", "told"), [(0.1, []), (0.01, ["along x, leant"])])
def test_forms_are_asked_with_all_effects_in_place(apart, told):
    split = Split([run(1, apart), run(2, apart)], [run(4, apart), run(5, apart)], [run(7, apart)])
    base = refitted(ToyRig(), split)
    found = search_effects(base, (ALONG_X, LEANT, ALONG_Y), split, tracer, floor=1.0)
    assert sorted(e.name for e in found.corrected.effects) == ["along x", "along y"]
    first = {t.candidate.name: t.select_error for t in found.rounds[0].trials}
    assert first["along x, leant"] < 1.02 * first["along x"]
    near = forms_beside(found, split)
    assert [t.candidate.name for t in near["along x"]] == told
