"""A fit asks for the same record hundreds of times: it is worked out once, until it is another."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np

from simpter_hybrid.identification.fitting.replay import Replay
from simpter_hybrid.identification.rigs.packed import packed

TIME = 0.01 * np.arange(5)
RUN = Replay("run", "run", TIME, {"drive": TIME}, {}, notes={"start": TIME[:2], "shift": TIME})


def counting():
    asked = []

    def pack(replay, period):
        asked.append(period)
        return period * replay.inputs["drive"]

    return SimpleNamespace(pack=pack, period=lambda replay, period, staged: 2.0 * period), asked


def test_the_same_run_begun_elsewhere_is_packed_once():
    rig, asked = counting()
    run = replace(RUN, memo={})
    packed(rig, run, 1.0, False)
    elsewhere = replace(run, notes={**run.notes, "start": 2.0 * TIME[:2]})
    period, data = packed(rig, elsewhere, 1.0, False)
    assert asked == [2.0]
    assert period == 2.0
    assert data.tolist() == (2.0 * TIME).tolist()


def test_other_inputs_notes_stages_and_rigs_are_packed_anew():
    rig, asked = counting()
    other, too = counting()
    run = replace(RUN, memo={})
    packed(rig, run, 1.0, False)
    packed(rig, replace(run, inputs={"drive": 3.0 * TIME}), 1.0, False)
    packed(rig, replace(run, notes={**run.notes, "shift": 3.0 * TIME}), 1.0, False)
    packed(rig, run, 1.0, None)
    packed(other, run, 1.0, False)
    assert asked == [2.0, 2.0, 2.0, 1.0]
    assert too == [2.0]
