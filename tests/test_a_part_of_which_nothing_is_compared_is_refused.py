from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from toy_rig import toy_replay

from simpter_hybrid.identification.fits import check_any_compared
from simpter_hybrid.problems import InvalidInput


def _bench(**compared):
    parts = {}
    for part, rows in compared.items():
        run = toy_replay(part, 1)
        seen = run.observed["torque"]
        keep = np.arange(seen.values.size) < rows
        parts[part] = [replace(run, observed={"torque": replace(seen, keep=keep)})]
    return SimpleNamespace(parts=parts)


def test_all_such_parts_are_named_at_once():
    recording = SimpleNamespace(source="data.csv")
    check_any_compared(_bench(fit=10, select=10, report=1), recording)
    with pytest.raises(InvalidInput) as told:
        check_any_compared(_bench(fit=10, select=0, report=0), recording)
    found = [str(problem) for problem in told.value.problems]
    assert "nothing of the runs that select can be compared" in found[0]
    assert "nothing of the runs that report can be compared" in found[1]
