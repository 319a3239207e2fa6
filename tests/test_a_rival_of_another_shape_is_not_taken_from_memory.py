from dataclasses import replace

from toy_rig import ALONG_X, ToyRig, toy_replay

from simpter_hybrid.identification.fitting.fitted_model import Split, refitted, with_effect
from simpter_hybrid.identification.fitting.memory import Memory
from simpter_hybrid.identification.fitting.search import try_candidates
from simpter_hybrid.identification.tracing.revision import with_rival


def test_a_rival_of_another_shape_is_not_taken_from_memory() -> None:
    split = Split([toy_replay("a", 1, scale=1.2, gain=0.7)], [toy_replay("b", 2, 1.2, 0.7)], [])
    declared = refitted(ToyRig(), split)
    trial = try_candidates(declared, [ALONG_X], split, floor=1.0)[0]
    model, memory = with_effect(declared, trial, split), Memory()
    p = ALONG_X.parameters[0]
    narrow = replace(ALONG_X, parameters=(replace(p, lower=-0.1, upper=0.1),))
    ended = replace(trial.fit, values={**trial.fit.values, p.name: 0.05}, cost=2.0 * trial.fit.cost)
    other = replace(trial, candidate=narrow, fit=ended)
    with_rival(trial, ALONG_X, model, declared, split, memory)
    again = with_rival(other, ALONG_X, model, declared, split, memory)
    assert again is not None
    assert again.effects == (narrow,)
    assert -0.1 <= again.values[p.name] <= 0.1
