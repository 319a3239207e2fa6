"""Its refit and its share stand for one another; their product is known better than either."""

from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.identifiability import Estimate
from simpter_hybrid.identification.reporting.parameters import declared_rows, wider

NUMBER = "clutch.1.time_constant"
TOLERANCES = [{"name": "lag", "parameters": [NUMBER], "relative": 0.2}]
ROWS = (Estimate("lag", 1.1, 0.33, "1"), Estimate("time-constant.share", 0.5, 0.45, "1"))


def told(tolerances, correlation):
    effect = SimpleNamespace(shares=(("time-constant.share", NUMBER),))
    model = SimpleNamespace(effects=[effect], values={r.name: r.value for r in ROWS})
    both = np.array([[1.0, correlation], [correlation, 1.0]])
    (row,) = declared_rows(model, tolerances, ROWS, both)
    return row


# Relative half-widths of 0.3 each, by hand.
@pytest.mark.parametrize(
    ("correlation", "relative"), [(-1.0, 0.0), (0.0, 0.3 * np.sqrt(2)), (1.0, 0.6)]
)
def test_its_interval_is_that_of_the_product(correlation, relative):
    row = told(TOLERANCES, correlation)
    assert row["name"] == f"{NUMBER} over declared"
    assert row["value"] == pytest.approx(1.1 * 1.5)
    assert row["half_width"] == pytest.approx(1.65 * relative, abs=1e-7)


def test_without_a_tolerance_it_is_the_share_alone():
    row = told([], 0.0)
    assert (row["value"], row["half_width"]) == (1.5, pytest.approx(0.45))


def test_an_effect_has_no_such_row():
    model = SimpleNamespace(effects=[SimpleNamespace()], values={})
    assert declared_rows(model, TOLERANCES, ROWS, np.eye(2)) == []


def test_of_two_steps_the_less_sure_one_counts():
    sure, less, unknown = ([{"name": "mass", "half_width": w}] for w in (0.01, 0.2, None))
    assert wider(sure, less) == wider(less, sure) == less
    assert wider(sure, unknown) == unknown
