"""Where friction alone acts only its ratio to the inertia shows: it is friction that differs."""

from dataclasses import replace
from types import SimpleNamespace

import pytest
from axis_recordings import declared_axis

from simpter_hybrid.identification.axis.bench import _weighed_once
from simpter_hybrid.identification.fitting.predictor import Parameter
from simpter_hybrid.identification.runwise_search import _asked

WEIGHT = {"name": "weight", "parameters": ["device.inertia"], "relative": 0.02}


def declared(others=True, **changed):
    """A wheel that only friction slows, or with a moment that turns it back, or a load."""
    axis = declared_axis()
    groups = [*(axis.notes["tolerances"] if others else ()), WEIGHT]
    device = replace(axis.device, weight=changed.pop("weight", 0.0))
    notes = {**axis.notes, "tolerances": groups}
    return replace(axis, **{"device": device, "loads": (), "notes": notes, **changed})


@pytest.mark.parametrize(
    ("made", "common"),
    [(declared(), ("weight",)), (declared(others=False), ()), (declared(weight=0.5), ()),
     (declared(loads=declared_axis().loads), ())],
    ids=["friction alone", "nothing else declared", "a pendulum", "a motor"],
)  # fmt: skip
def test_an_inertia_is_the_same_where_friction_alone_acts(made, common):
    assert _weighed_once(made) == common


def test_of_what_is_common_it_is_not_asked():
    names = ("weight", "friction")
    known = [Parameter(n, 1.0, 0.5, 1.5, 0.01, tolerance=0.1) for n in names]
    fitted = Parameter("drag", 0.0, -1.0, 1.0, 0.01)
    model = SimpleNamespace(predictor=SimpleNamespace(parameters=[*known, fitted]))
    assert _asked(model, ("weight",)) == ["friction"]
    assert _asked(model, ()) == [*names]
