"""Where nothing helps, the sentence says whether what is left is as small as noise."""

from types import SimpleNamespace as Some

import pytest

from simpter_hybrid.identification.sentences import verdict_sentence
from simpter_hybrid.identification.verdict import Verdict


def said(ratio):
    model = Some(effects=(), select=ratio)
    diagnosis = Some(verdict=Verdict("nothing missing"), corrected=model, floor=1.0)
    return verdict_sentence(Some(diagnosis=diagnosis))


def test_near_the_floor():
    assert said(1.02).endswith("is noise.")


@pytest.mark.parametrize("ratio", [1.16, 3.8])
def test_far_from_it(ratio):
    assert f"{ratio:.2f} times the floor, more than noise alone" in said(ratio)
