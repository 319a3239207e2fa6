"""A refit that has ended beside the right valley takes over the share that has led into it."""

from dataclasses import dataclass

import numpy as np
import pytest
from toy_rig import ToyRig, toy_replay, tracer

from simpter_hybrid.identification.fitting.fitted_model import Split, refitted
from simpter_hybrid.identification.fitting.predictor import Candidate, Parameter
from simpter_hybrid.identification.tracing.rounds import search_effects

SHARE = Candidate(
    "share", (Parameter("share", 0.0, -0.9, 1.0, 0.01),), ((0.05,),), "scale", "friction", (),
    declared=True,
)  # fmt: skip


def _size(scale):
    """Rises with the scale, but between 1.05 and 1.1 falls: no step leads over that."""
    return float(np.interp(scale, [0.5, 1.05, 1.1, 1.2, 1.5], [0.5, 1.05, 0.7, 1.15, 2.5]))


@dataclass(frozen=True)
class Stuck(ToyRig):
    """torque = (1 + share) size(scale) u."""

    def predict(self, values, replays):
        size = _size(values["scale"]) * (1.0 + values.get("share", 0.0))
        return {"torque": [size * r.inputs["u"] for r in replays]}


class Taking(Stuck):
    """That knows what the share is a share of."""

    def absorbed(self, candidate, values):
        return {**values, "scale": values["scale"] * (1.0 + values["share"])}


def _search(rig):
    runs = [toy_replay("run", k, scale=_size(1.2), experiment="abc"[k % 3]) for k in (1, 2, 4, 5)]
    split = Split(runs[:2], runs[2:], [])
    base = refitted(rig, split)
    return search_effects(base, [SHARE], split, tracer, floor=1.0), base


def test_the_refit_does_so_by_itself():
    found, base = _search(Taking())
    assert base.select_error > 1.2
    assert found.verdict.kind == "nothing missing"
    assert found.refitted.values["scale"] == pytest.approx(1.2, abs=0.01)


def test_without_that_the_share_would_be_named():
    found, _ = _search(Stuck())
    assert [e.name for e in found.corrected.effects] == ["share"]
