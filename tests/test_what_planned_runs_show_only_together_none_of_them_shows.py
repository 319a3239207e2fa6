"""A planned run is judged beside the runs that were made, not beside others that could be made."""

from dataclasses import replace

import pytest
from toy_rig import ALONG_X, ToyRig, toy_replay

from simpter_hybrid.identification.fitting.fitted_model import Split, refitted
from simpter_hybrid.identification.identifiability_report import sight

AGAIN, OTHER = "once more", "another x"


def _run(name, seed, along_u):
    run = toy_replay(name, seed)
    x = run.inputs["u"] if along_u else run.inputs["x"]
    return replace(run, name=name, experiment=name, inputs={**run.inputs, "x": x})


@pytest.fixture(scope="module")
def seen():
    made = [_run("made", 1, True)]
    base = refitted(ToyRig(), Split(made, made, []))
    return sight(base, [ALONG_X], made, [_run(AGAIN, 1, True), _run(OTHER, 2, False)])


def test_the_run_that_was_made_shows_no_more_when_it_is_made_again(seen):
    assert seen.blind == ("along x",)
    assert dict(seen.reveals["along x"])[AGAIN] < seen.needed[AGAIN]


def test_one_that_is_another_does(seen):
    (first, size), *_ = seen.reveals["along x"]
    assert first == OTHER
    assert size > 3.0 * seen.needed[OTHER]
