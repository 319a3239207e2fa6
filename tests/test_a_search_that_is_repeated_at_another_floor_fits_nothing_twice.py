import numpy as np
import pytest
from toy_rig import ALONG_X, ALONG_Y, ToyRig, toy_replay

from simpter_hybrid.identification.fitting.fit import Fitter
from simpter_hybrid.identification.fitting.fitted_model import Split, refitted
from simpter_hybrid.identification.fitting.memory import Memory
from simpter_hybrid.identification.fitting.search import try_candidates


@pytest.fixture
def fits(monkeypatch):
    """Fits as they are begun."""
    begun, fit = [], Fitter.fit

    def counted(self, *args, **more):
        begun.append(self)
        return fit(self, *args, **more)

    monkeypatch.setattr(Fitter, "fit", counted)
    return begun


def searched(base, split, floor, memory):
    return try_candidates(base, [ALONG_X, ALONG_Y], split, floor, memory=memory)


def test_only_what_a_floor_decides_is_another(fits):
    runs = [toy_replay("a", 1, gain=0.3), toy_replay("b", 2, gain=0.3, experiment="b")]
    split, memory = Split(runs[:1], runs[1:], []), Memory()
    base = refitted(ToyRig(), split)
    first = searched(base, split, 1.0, memory)
    count = len(fits)
    again = searched(base, split, 0.5, memory)
    assert len(fits) == count > 1
    assert [t.fit for t in again] == [t.fit for t in first]
    assert again[0].share != first[0].share


def test_another_base_is_fitted_anew(fits):
    runs = [toy_replay(name, k, gain=0.3, experiment=name) for k, name in enumerate("abc")]
    memory = Memory()
    for fitted in runs[:2]:
        split = Split([fitted], runs[2:], [])
        (best, _) = searched(refitted(ToyRig(), split), split, 1.0, memory)
        alone = searched(refitted(ToyRig(), split), split, 1.0, Memory())[0]
        assert np.array_equal(best.fit.residuals, alone.fit.residuals)
