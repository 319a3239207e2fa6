"""All curves are asked where a refit that went far has bent a residual, or much stays left."""

from types import SimpleNamespace

import pytest
from asked_curves import concluded, curve

from simpter_hybrid.identification.fitting.predictor import Parameter
from simpter_hybrid.identification.tracing.verdict import Verdict

REVERSAL = "force:displacement_since_reversal"


def asked(monkeypatch, mass, where, share, left=1.1):
    """The coordinates told of an unknown lack: of mass to 5 %, and curves over `where`."""
    declared = Parameter("mass", 1.0, 0.5, 1.5, 0.01, tolerance=0.05)
    model = SimpleNamespace(
        select_error=8.0, values={"mass": mass}, predictor=SimpleNamespace(parameters=(declared,))
    )
    unknown, known = Verdict("unknown", coordinates=(where,)), curve(left, share)
    given = unknown, (model, model), known if share else None, REVERSAL, curve(2.0)
    return concluded(monkeypatch, *given).verdict.coordinates


def test_all_curves_are_asked_after_a_refit_that_went_far(monkeypatch):
    assert asked(monkeypatch, 1.17, "force:acceleration", 0.0) == (REVERSAL,)
    assert asked(monkeypatch, 1.17, "force:acceleration", 0.1) == (REVERSAL,)


@pytest.mark.parametrize(
    ("mass", "where", "share"),
    [
        (1.05, "force:acceleration", 0.0),  # a refit within what is declared
        (1.17, "force:position", 0.6),  # a curve that explains it
        (1.17, "ringing:breakaway", 0.0),  # nothing that a curve could be drawn over
    ],
)
def test_else_what_was_located_stays(monkeypatch, mass, where, share):
    assert asked(monkeypatch, mass, where, share) == (where,)


@pytest.mark.parametrize(("left", "told"), [(4.0, REVERSAL), (2.2, "force:position")])
def test_a_curve_that_leaves_far_less_is_told_in_its_place(monkeypatch, left, told):
    assert asked(monkeypatch, 1.0, "force:position", 0.8, left) == (told,)
