import numpy as np
import pytest

import simpter_hybrid as sh
from simpter_hybrid.cases import CannotVary

pytest.importorskip("llvmlite", reason="the compiled engine needs llvmlite")
from simpter_hybrid.ensemble import ensemble


def test_an_ensemble_of_no_case_is_refused() -> None:
    with pytest.raises(CannotVary, match="no case"):
        ensemble(sh.load("testbed-step-0-8"), {"clutch.1.torque.scale": np.zeros(0)})
