"""An empty list, as a filter in Python may leave, is no sweep of nothing."""

import numpy as np
import pytest

import simpter_hybrid as simpter
from simpter_hybrid.problems import InvalidInput


@pytest.mark.parametrize("values", [[], (), np.zeros(0)])
def test_and_nothing_is_written(tmp_path, values):
    with pytest.raises(InvalidInput, match=r"vary loads\.0\.along: no values.*one or more"):
        simpter.sweep("line-y24", {"loads.0.along": values}, tmp_path / "s", engine="reference")
    assert not (tmp_path / "s").exists()
