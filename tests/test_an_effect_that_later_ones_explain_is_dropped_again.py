"""What an effect still explains beside later ones is asked of all runs and of each experiment's."""

import pytest
from toy_rig import ALONG_X, ALONG_Y, ToyRig, toy_replay

from simpter_hybrid.identification.fitting.fitted_model import Split, Trial, refitted
from simpter_hybrid.identification.tracing.revision import asked_again, without_needless
from simpter_hybrid.identification.tracing.verdict import Verdict

BOTH = (ALONG_X, ALONG_Y)


def _corrected(gain):
    """A model with both effects; the first is in the one run of six that is of experiment `b`."""

    def runs(seed):
        others = [toy_replay(f"a{k}", seed + k, experiment="a") for k in range(5)]
        return [*others, toy_replay("b", seed + 9, gain=gain, experiment="b")]

    split = Split(runs(10), runs(30), [])
    rig = ToyRig().extended(ALONG_X).extended(ALONG_Y)
    return refitted(rig, split, BOTH), refitted(ToyRig(), split), split


@pytest.mark.parametrize(("gain", "kept"), [(0.0, 1), (0.12, 2)])
def test_an_effect_that_one_experiment_shows_is_kept(gain, kept):
    # All six runs together show 0.9 % of it, less than is asked of all; those of `b` show 7 %.
    model, declared, split = _corrected(gain)
    assert len(without_needless(model, declared, split).effects) == kept


def test_what_was_dropped_has_no_rivals_left():
    model, declared, split = _corrected(0.0)
    smaller = without_needless(model, declared, split)
    rival = Trial(ALONG_Y, None, 1.0, 0.5, 1.0)
    first = Verdict(
        "cannot be told apart", Trial(ALONG_X, None, 1.0, 0.5, 1.0), (rival,), (), ("x",)
    )
    asked = asked_again(first, smaller, declared, split, floor=1.0)
    assert (asked.rivals, asked.as_well) == ((), ())
