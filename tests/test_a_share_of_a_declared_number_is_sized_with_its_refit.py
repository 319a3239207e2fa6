"""A share of a declared number and the refit of that number: their product is what is known."""

from types import SimpleNamespace

import pytest

from simpter_hybrid.identification.fitting.predictor import Parameter
from simpter_hybrid.identification.reporting.refits import refit_sentence
from simpter_hybrid.identification.reporting.size_intervals import sizes_may_be_zero

NUMBER, SHARE = "clutch.1.time_constant", "time-constant.share"
EFFECT = SimpleNamespace(name="time-constant", sizes=(SHARE,), shares=((SHARE, NUMBER),))
LAG = Parameter("time constant", 1.0, 0.3, 1.7, 0.05, tolerance=0.2)


def told(product):
    """A share of 0.43 that may be zero, and the product."""
    share = {"name": SHARE, "value": 0.43, "half_width": 0.44}
    return {SHARE: share, f"clutch.2.torque, {NUMBER} over declared": product}


@pytest.mark.parametrize(
    ("value", "half_width", "none"), [(1.89, 0.01, False), (1.3, 0.4, True), (1.9, None, True)]
)
def test_it_may_be_nothing_where_the_product_may_be_what_was_declared(value, half_width, none):
    product = {"value": value, "half_width": half_width}
    assert sizes_may_be_zero(EFFECT, told(product)) is none


def test_without_the_product_the_share_counts():
    assert sizes_may_be_zero(EFFECT, {SHARE: {"value": 0.43, "half_width": 0.44}})


@pytest.mark.parametrize(("effects", "said"), [((), True), ((EFFECT,), False)])
def test_its_refit_alone_is_not_told_beside_it(effects, said):
    tolerances = [{"name": "time constant", "parameters": [NUMBER], "relative": 0.2}]
    declared = SimpleNamespace(notes={"tolerances": tolerances})
    predictor = SimpleNamespace(parameters=(LAG,), declared=declared)
    model = SimpleNamespace(effects=effects, values={LAG.name: 1.32}, predictor=predictor)
    found = SimpleNamespace(search=SimpleNamespace(corrected=model))
    assert ("time constant +32.0 %" in refit_sentence(found)) is said
